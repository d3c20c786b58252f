#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Ten minutes of a random operator in every exercise and in three patients; prints a table.

usage: scripts/dev/random_operator.py [--seconds 600] [--tetrahedra 1000] [--replay] [--jobs 2] [--rhexis PROGRAM]

For each: errors raised, steps that had to be redone, what part of the lens's volume is not accounted for, CPU seconds per
simulated second, and with --replay whether a second simulation gives the same state hash in every step.
"""

import argparse
import concurrent.futures
import pathlib
import subprocess
import sys
import tempfile

import attempts

DENSITY = 1.05  # of the lens [mg/mm^3]
RUNS = [
    ("phaco_sculpt", None),
    ("phaco_quadrants", None),
    ("phaco_crack", None),
    ("phaco_sculpt", "white"),
    ("phaco_quadrants", "soft"),
    ("groove", None),
    ("phaco_sculpt", "brunescent"),
]


def volume(series, index):
    """Of the whole lens: what went and what is left, crumbs included [mm^3]."""
    left = series.get("fragments.left_mm3")
    return None if left is None else series["lens.removed_mg"][index] / DENSITY + left[index]


def one(options, exercise, patient, folder):
    more = ["--limit", str(options.seconds), "--set", f"time_limit_s={options.seconds}"]
    if options.tetrahedra:
        more += ["--set", f"patient.tetrahedra={options.tetrahedra}"]
    if patient:
        more += ["--patient", str(attempts.ROOT / "assets" / "patients" / f"{patient}.json")]
    report = attempts.attempt(options.rhexis, exercise, "random", 11, folder, more)
    series = attempts.series(folder)
    first, last = volume(series, 0), volume(series, -1)
    lost = "-" if first is None else f"{100 * abs(last - first) / first:.3f} %"
    same = "-"
    if options.replay:
        replay = [options.rhexis, "replay", str(folder / "recording.rhx"), "--verify"]
        same = "yes" if subprocess.run(replay, cwd=attempts.ROOT, stdout=subprocess.DEVNULL).returncode == 0 else "NO"
    performance = report["performance"]
    return [exercise, patient or "its own", f"{report['duration_s']:.0f} s", len(report["events"]),
            f"{performance['rollbacks']} of {performance['steps']}", lost, f"{performance['cpu_s_per_s']:.2f}", same]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=600)
    parser.add_argument("--tetrahedra", type=int, default=1000, help="0: as the exercise says")
    parser.add_argument("--replay", action="store_true", help="simulate again and compare every step")
    parser.add_argument("--rhexis", default=attempts.PROGRAM)
    parser.add_argument("--only", help="an exercise")
    parser.add_argument("--jobs", type=int, default=1)
    options = parser.parse_args()
    attempts.table_head(["exercise", "patient", "simulated", "errors", "steps redone", "volume lost", "CPU s per s",
                         "same hash"])
    runs = [run for run in RUNS if options.only in (None, run[0])]

    def row_of(run):
        with tempfile.TemporaryDirectory() as folder:
            return one(options, *run, pathlib.Path(folder) / "run")

    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for row in pool.map(row_of, runs):
            attempts.table_row(row)


if __name__ == "__main__":
    sys.exit(main())
