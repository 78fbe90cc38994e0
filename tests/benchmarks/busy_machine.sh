#!/usr/bin/env bash
# busy_machine.sh PROGRAM [ARGUMENT...]   how a command of several threads fares beside eight other busy processes
#
# Runs the command alone, then beside the others, and prints by how much it takes longer than its fair share of the processors.
# Its threads are as many as want a processor on average (processor time over wall time when it is alone); each gets what each
# of the others gets:
#   share of a thread = processors / (8 + threads), fair time = processor time / (threads * share)
# Threads that spin, or that wait for one that is not running, make it more than 1. Nothing else may run meanwhile.
set -euo pipefail
[ $# -ge 1 ] || { sed -n 2p "$0" >&2; exit 2; }
processors=$(nproc) others=8

# Prints wall, user and system seconds of the command.
seconds() {
  local TIMEFORMAT="%R %U %S"
  { time "$@" >/dev/null 2>&1; } 2>&1
}

alone=$(seconds "$@")
busy=()
trap 'kill "${busy[@]}" 2>/dev/null || true' EXIT
for ((i = 0; i < others; ++i)); do
  (while :; do :; done) &
  busy+=($!)
done
beside=$(seconds "$@")

awk -v alone="$alone" -v beside="$beside" -v processors="$processors" -v others="$others" 'BEGIN {
  split(alone, a, " "); split(beside, b, " ")
  threads = (a[2] + a[3]) / a[1]
  share = processors / (others + threads)
  if (share > 1) share = 1
  used = b[2] + b[3]
  fair = used / (threads * share)
  printf "alone          %6.1f s, %6.1f s of processor time: %.2f threads\n", a[1], a[2] + a[3], threads
  printf "beside %d busy  %6.1f s, %6.1f s of processor time; fair would be %.1f s\n", others, b[1], used, fair
  printf "ratio          %6.2f\n", b[1] / fair
}'
