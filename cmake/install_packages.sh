#!/usr/bin/env bash
# install_packages.sh: installs what building and testing Sonoskin needs on Debian 12, and only what is missing.
# Needs root or sudo where something is missing, nothing otherwise. Safe to run again.
set -euo pipefail

packages=(
  # compiler and build
  g++ cmake ninja-build python3 python3-glad
  # data: ITK brings its own dependencies; the others are small or headers only
  libinsighttoolkit5-dev libassimp-dev libxxhash-dev libqhull-dev libstb-dev zlib1g-dev libbz2-dev libdeflate-dev
  libmeshoptimizer-dev libexpat1-dev libminizip-dev libdraco-dev
  libeigen3-dev libnanoflann-dev libglm-dev nlohmann-json3-dev libcli11-dev libfmt-dev
  # pictures and window: GLVND's headers, Mesa's software rasteriser, OSMesa (loaded when asked for)
  libegl-dev libgl-dev libopengl-dev libegl-mesa0 libgl1-mesa-dri libglx-mesa0 libosmesa6
  libglfw3-dev libx11-dev libimgui-dev libfreetype-dev fonts-inter fonts-dejavu-core
  # tests: a display without a monitor, a hand for its mouse, and screenshots
  libgtest-dev libbenchmark-dev libdcmtk-dev xvfb xauth xdotool x11-utils imagemagick
  # tests: what the fuzzers are built with, and the judge of the format
  clang-14 libclang-rt-14-dev clang-format-14
)

missing=()
for package in "${packages[@]}"; do
  if [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" != installed ]; then
    missing+=("$package")
  fi
done
if [ ${#missing[@]} -eq 0 ]; then
  echo "install: every package is there"
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "install: these packages are missing; run this as root, or install sudo: ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi

echo "install: ${missing[*]}"
apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3 -q)
"${apt[@]}" update
"${apt[@]}" install -y --no-install-recommends "${missing[@]}"
