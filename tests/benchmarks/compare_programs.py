#!/usr/bin/env python3
"""Two builds of the program on the same command, alternately: wall time, processor time and memory, and their ratios.

usage: compare_programs.py [--rounds N] OLD NEW WORD...
       {} among the words stands for a new folder or file name, apart for each run
e.g.:  compare_programs.py ~/sonoskin_before build/release/sonoskin run scan.nrrd --out {}

The least of the rounds counts, since other programs only ever add; it prints each run too. Processor time is user and
system, of all threads and of the process that reads; memory is the most that one of them had at once.
"""
import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import time

UNITS = (("wall", "s"), ("processor", "s"), ("memory", "MB"))


def measured(words):
    """Wall seconds, processor seconds and megabytes of one run."""
    begin = time.monotonic()
    process = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    said = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    wall = time.monotonic() - begin
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"{' '.join(words)} ended with {process.returncode}: {said.decode(errors='replace')}")
    return wall, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1e3


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("words", nargs=argparse.REMAINDER, help="the command, with {} for its output")
    asked = parser.parse_args()
    runs = {asked.old: [], asked.new: []}
    for round_ in range(asked.rounds):
        for program in runs:
            folder = tempfile.mkdtemp()
            words = [word.replace("{}", os.path.join(folder, "out.png")) for word in asked.words]
            runs[program].append(measured([program, *words]))
            shutil.rmtree(folder)
            wall, processor, memory = runs[program][-1]
            print(f"  {round_ + 1} {program}: {wall:.2f} s, {processor:.2f} s of processors, {memory:.0f} MB", file=sys.stderr)
    old, new = ([min(column) for column in zip(*runs[program])] for program in (asked.old, asked.new))
    for (name, unit), before, after in zip(UNITS, old, new):
        print(f"{name:10} {before:8.2f} {unit:2} -> {after:8.2f} {unit:2}   x {after / before:.2f}")


if __name__ == "__main__":
    main()
