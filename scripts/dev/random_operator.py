#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Ten minutes of a random operator in every exercise and in three patients; prints a table.

usage: scripts/dev/random_operator.py [--seconds 600] [--tetrahedra 1000] [--replay] [--rhexis PROGRAM]

For each: errors raised, steps that had to be redone, what part of the lens's volume is not accounted for, CPU seconds per
simulated second, and with --replay whether a second simulation gives the same state hash in every step.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
RUNS = [
    ("groove", None),
    ("phaco_sculpt", None),
    ("phaco_crack", None),
    ("phaco_quadrants", None),
    ("phaco_sculpt", "white"),
    ("phaco_sculpt", "brunescent"),
    ("phaco_quadrants", "soft"),
]


def volume(series, index):
    measures = series["measures"]
    removed = measures["lens.removed_mm3"]["values"][index]
    left = measures.get("fragments.left_mm3")
    return None if left is None else removed + left["values"][index]


def one(options, exercise, patient, folder):
    command = [options.rhexis, "run", exercise, "--surgeon", "random", "--seed", "11", "--no-pictures",
               "--out", str(folder), "--limit", str(options.seconds), "--set", f"time_limit_s={options.seconds}"]
    if options.tetrahedra:
        command += ["--set", f"patient.tetrahedra={options.tetrahedra}"]
    if patient:
        command += ["--patient", str(ROOT / "assets" / "patients" / f"{patient}.json")]
    subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    report = json.loads((folder / "report.json").read_text())
    series = json.loads((folder / "series.json").read_text())
    first, last = volume(series, 0), volume(series, -1)
    lost = "-" if first is None else f"{100 * abs(last - first) / first:.3f} %"
    same = "-"
    if options.replay:
        replay = [options.rhexis, "replay", str(folder / "recording.rhx"), "--verify"]
        same = "yes" if subprocess.run(replay, cwd=ROOT, stdout=subprocess.DEVNULL).returncode == 0 else "NO"
    performance = report["performance"]
    return [exercise, patient or "its own", f"{report['duration_s']:.0f} s", len(report["events"]),
            f"{performance['rollbacks']} of {performance['steps']}", lost, f"{performance['cpu_s_per_s']:.2f}", same]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=600)
    parser.add_argument("--tetrahedra", type=int, default=1000, help="0: as the exercise says")
    parser.add_argument("--replay", action="store_true", help="simulate again and compare every step")
    parser.add_argument("--rhexis", default=str(ROOT / "build" / "release" / "bindings" / "cli" / "rhexis"))
    parser.add_argument("--only", help="an exercise")
    options = parser.parse_args()
    print("| exercise | patient | simulated | errors | steps redone | volume lost | CPU s per s | same hash |")
    print("|---|---|---|---|---|---|---|---|")
    for exercise, patient in RUNS:
        if options.only and options.only != exercise:
            continue
        with tempfile.TemporaryDirectory() as folder:
            row = one(options, exercise, patient, pathlib.Path(folder) / "run")
        print("| " + " | ".join(str(cell) for cell in row) + " |", flush=True)


if __name__ == "__main__":
    sys.exit(main())
