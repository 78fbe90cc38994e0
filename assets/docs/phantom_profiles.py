#!/usr/bin/env python3
"""phantom_profiles.py OUT.png: draws what edges of the skin look like in the simulated scenes, and prints their figures.

For each scene the greys along the normals of the true skin where the probe sees it, smoothed over 0.6 mm, each profile
aligned at its steepest rise, and averaged over three heads. Needs build/release/sonoskin (or SONOSKIN), python3-numpy,
python3-scipy and python3-matplotlib. A minute.
"""
import gzip
import os
import pathlib
import subprocess
import sys
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from scipy.ndimage import gaussian_filter, map_coordinates

PROGRAM = os.environ.get("SONOSKIN", str(pathlib.Path(__file__).resolve().parents[2] / "build/release/sonoskin"))
SCENES = ["clear", "haze", "saturated", "enhanced", "thick", "clinical"]
BLUR, STEP, REACH, SEARCH, SIDE = 0.6, 0.1, 7.0, 2.5, 4.0  # mm


def read_volume(path):
    head, data = path.read_bytes().split(b"\n\n", 1)
    field = dict(line.split(": ", 1) for line in head.decode().splitlines() if ": " in line and line[0] != "#")
    dims = [int(n) for n in field["sizes"].split()]
    spacing = [max(abs(float(x)) for x in axis.strip("()").split(",")) for axis in field["space directions"].split()]
    if field["encoding"] == "gzip":
        data = gzip.decompress(data)
    return np.frombuffer(data, np.uint8).reshape(dims, order="F") / 255.0, np.array(spacing)


def read_truth(path):
    """Places and normals of the skin that the probe sees and that faces it."""
    with open(path, "rb") as file:
        kinds, count, in_vertices = [], 0, False
        while (word := file.readline().split())[0] != b"end_header":
            if word[0] == b"element":
                in_vertices = word[1] == b"vertex"
                count = int(word[2]) if in_vertices else count
            elif word[0] == b"property" and in_vertices:
                kinds.append((word[2].decode(), {b"float": "<f4", b"uchar": "u1"}[word[1]]))
        v = np.frombuffer(file.read(np.dtype(kinds).itemsize * count), kinds)
    v = v[(v["visibility"] > 0.5) & (v["ny"] < -0.5)]
    return np.stack([v["x"], v["y"], v["z"]], 1), np.stack([v["nx"], v["ny"], v["nz"]], 1)


def mean_profile(scene, folder):
    t = np.arange(-REACH, REACH + STEP / 2, STEP)  # mm behind the skin
    around = np.arange(-SIDE, SIDE + STEP / 2, STEP)
    total, count = np.zeros(len(around)), 0
    for shape in range(3):
        volume, truth = folder / "v.nrrd", folder / "t.ply"
        subprocess.run([PROGRAM, "phantom", "--out", volume, "--truth", truth, "--dims", "256x144x72", "--scene", scene,
                        "--shape", str(shape), "--seed", str(shape + 1)], check=True, capture_output=True)
        grey, spacing = read_volume(volume)
        smooth = gaussian_filter(grey, BLUR / spacing)
        place, normal = read_truth(truth)
        index = (place[:, None] - normal[:, None] * t[None, :, None]) / spacing - 0.5
        profile = map_coordinates(smooth, index.reshape(-1, 3).T, order=1, mode="nearest").reshape(len(place), -1)
        slope = np.where(np.abs(t[1:-1]) <= SEARCH, profile[:, 2:] - profile[:, :-2], -1)
        first = slope.argmax(1) + 1 - len(around) // 2
        total += np.take_along_axis(profile, first[:, None] + np.arange(len(around)), 1).sum(0)
        count += len(place)
    return around, total / count


def figures(x, y):
    """Dark and bright side, mm from 20 to 80 % between them, grey at the steepest place."""
    dark = y[(x > -3.55) & (x < -1.95)].mean()
    peak = len(x) // 2 + y[len(x) // 2:].argmax()
    rising = np.maximum.accumulate(y[: peak + 1])
    low, high = np.interp([dark + s * (y[peak] - dark) for s in (0.2, 0.8)], rising, x[: peak + 1])
    return dark, y[peak], high - low, y[: peak + 1][np.gradient(y[: peak + 1]).argmax()]


def main():
    figure, axes = plt.subplots(figsize=(9, 5.4), facecolor="#15171b")
    axes.set_facecolor("#15171b")
    with tempfile.TemporaryDirectory() as folder:
        for number, scene in enumerate(SCENES):
            x, y = mean_profile(scene, pathlib.Path(folder))
            dark, bright, rise, steepest = figures(x, y)
            print(f"{scene:10s} dark {dark:.2f}  bright {bright:.2f}  20 to 80 % {rise:.2f} mm  steepest at {steepest:.2f}")
            axes.plot(x, y, lw=2.4 if scene in ("thick", "clinical") else 1.4, color=plt.cm.viridis(0.3 + 0.13 * number),
                      label=f"{scene}: {dark:.2f} to {bright:.2f}, {rise:.1f} mm, {steepest:.2f}")
    axes.set_xlabel("mm behind the steepest place")
    axes.set_ylabel("grey")
    axes.set_ylim(0, 1)
    axes.legend(title="dark to bright side, 20 to 80 %, grey at the steepest place", frameon=False, labelcolor="#d8d8d8",
                loc="upper left").get_title().set_color("#d8d8d8")
    for item in [axes.xaxis.label, axes.yaxis.label, *axes.get_xticklabels(), *axes.get_yticklabels()]:
        item.set_color("#d8d8d8")
    axes.grid(alpha=0.2)
    figure.tight_layout()
    figure.savefig(sys.argv[1], dpi=100, metadata={"Software": None})


if __name__ == "__main__":
    main()
