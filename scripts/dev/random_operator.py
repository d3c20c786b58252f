#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Ten minutes of a random operator in every exercise and in three patients; prints a table.

usage: scripts/dev/random_operator.py [--seconds 600] [--seed 11] [--tetrahedra 1000] [--replay] [--only EXERCISE] [--jobs 2]
       [--rhexis PROGRAM]

For each: attempts that it took (one that ends early is followed by another with the next seed), errors raised, steps that
had to be redone, what part of the lens's volume is not accounted for at most, CPU seconds per simulated second, and with
--replay whether a second simulation gives the same state hash in every step.
"""

import argparse
import concurrent.futures
import pathlib
import subprocess
import sys
import tempfile

import attempts

SHORTEST = 1.0  # attempt that an exercise takes [s]
DENSITY = 1.05  # of the lens [mg/mm^3]
RUNS = [
    ("phaco_sculpt", None),
    ("phaco_quadrants", None),
    ("phaco_crack", None),
    ("phaco_sculpt", "white"),
    ("phaco_quadrants", "soft"),
    ("groove", None),
    ("phaco_sculpt", "brunescent"),
    ("capsulorhexis", None),
    ("capsulorhexis_rescue", None),
    ("iol_injection", None),
    ("wound_burn", None),
    ("iris_prolapse", None),
    ("incision", None),
    ("wound_closure", None),
    ("hydrodissection", None),
    ("cortex", None),
    ("zonular_weakness", None),
    ("viscoelastic_removal", None),
    ("set_up", None),
    ("forceps_skill", None),
    ("navigation", None),
    ("overfilled_chamber", None),
    ("surge", None),
    ("dropped_fragment", None),
    ("posterior_capsule_rupture", None),
]


def volume(series, index):
    """Of the whole lens: what went and what is left, crumbs included [mm^3]."""
    left = series.get("fragments.left_mm3")
    return None if left is None else series["lens.removed_mg"][index] / DENSITY + left[index]


def volume_lost(series):
    """What is not accounted for at the end, of the volume at the start; None for an exercise without a lens."""
    first, last = volume(series, 0), volume(series, -1)
    return None if first is None else abs(last - first) / first


def options_of(patient, seconds, tetrahedra):
    """Further options of rhexis run."""
    more = ["--limit", str(seconds), "--set", f"time_limit_s={seconds}"]
    if tetrahedra:
        more += ["--set", f"patient.tetrahedra={tetrahedra}"]
    if patient:
        more += ["--patient", str(attempts.ROOT / "assets" / "patients" / f"{patient}.json")]
    return more


def replays(program, folder):
    """Whether a second simulation ends every step in the same state."""
    command = [program, "replay", str(folder / "recording.rhx"), "--verify"]
    return subprocess.run(command, cwd=attempts.ROOT, stdout=subprocess.DEVNULL).returncode == 0


def all_attempts(options, exercise, patient, folder):
    """Attempts until they make up the time: of each its report, the volume lost, and whether it replays."""
    found, left = [], options.seconds
    while left > 0:
        here = folder / str(len(found))
        more = options_of(patient, max(left, SHORTEST), options.tetrahedra)
        report = attempts.attempt(options.rhexis, exercise, "random", options.seed + len(found), here, more)
        same = replays(options.rhexis, here) if options.replay else None
        found.append((report, volume_lost(attempts.series(here)), same))
        left -= report["duration_s"]
    return found


def one(options, exercise, patient, folder):
    found = all_attempts(options, exercise, patient, folder)
    reports = [report for report, _, _ in found]
    lost = [share for _, share, _ in found if share is not None]
    seconds = sum(report["duration_s"] for report in reports)
    redone, steps = (sum(report["performance"][name] for report in reports) for name in ("rollbacks", "steps"))
    cpu = sum(report["performance"]["cpu_s_per_s"] * report["duration_s"] for report in reports)
    return [exercise, patient or "its own", f"{seconds:.0f} s", len(found), sum(len(r["events"]) for r in reports),
            f"{redone} of {steps}", f"{100 * max(lost):.3f} %" if lost else "-", f"{cpu / seconds:.2f}",
            ("yes" if all(same for _, _, same in found) else "NO") if options.replay else "-"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=600)
    parser.add_argument("--seed", type=int, default=11, help="of the first attempt")
    parser.add_argument("--tetrahedra", type=int, default=1000, help="0: as the exercise says")
    parser.add_argument("--replay", action="store_true", help="simulate again and compare every step")
    parser.add_argument("--rhexis", default=attempts.PROGRAM)
    parser.add_argument("--only", help="an exercise")
    parser.add_argument("--jobs", type=int, default=1)
    options = parser.parse_args()
    attempts.table_head(["exercise", "patient", "simulated", "attempts", "errors", "steps redone", "volume lost", "CPU s per s",
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
