#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a tracking system changes in a score: the same surgeon and seed with bare hands, with hands as a rig of cameras
sees them (rhexis run --through), and with hands moved by 1 um, which shows how much of a difference is chance.

  scripts/dev/chain_study.py                                      both exercises, seeds 501 to 510; hours
  scripts/dev/chain_study.py --exercises phaco_sculpt --seeds 601-603 --images 0 --results mine.csv
  scripts/dev/chain_study.py --only-table                         of what is there

Each attempt is a line of --results; one that is there is not run again, so a study that was ended goes on. The first
--images seeds go through rendered images, the others through markers alone. Needs `ninja -C build/release`.
"""

import argparse
import concurrent.futures
import csv
import math
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile
import threading

import attempts
from study import seeds_of

ARMS = ("bare", "through", "moved")
FIELDS = ("exercise", "group", "seed", "arm", "level", "total_of_100", "completed", "duration_s", "tremor_um",
          "tip_off_rms_um", "tip_off_most_um", "not_seen_percent", "stood_steps", "state_hash")


class Results:
    """Lines of a CSV file, by exercise, group, seed, arm and level; threads may add to it."""

    def __init__(self, path):
        self.path = path
        self.lock = threading.Lock()
        self.lines = {}
        if path.exists():
            with path.open(newline="") as file:
                self.lines = {self.key(line): line for line in csv.DictReader(file)}

    @staticmethod
    def key(line):
        return tuple(str(line[field]) for field in FIELDS[:5])

    def add(self, line):
        with self.lock:
            begins = not self.path.exists()
            with self.path.open("a", newline="") as file:
                writer = csv.DictWriter(file, FIELDS, lineterminator="\n")
                if begins:
                    writer.writeheader()
                writer.writerow(line)
            self.lines[self.key(line)] = line


def rig_for(options, folder, exercise):
    """A calibrated rig whose bodies are those of the exercise."""
    setup = folder / f"rig-{exercise}" / "track.json"
    for command in (["begin", str(setup.parent), "--exercise", exercise], ["calibrate", str(setup)]):
        done = subprocess.run([options.rhexis, "track", *command], cwd=attempts.ROOT, capture_output=True, text=True)
        if done.returncode != 0:
            raise SystemExit(done.stderr.strip())
        print(done.stdout.strip(), file=sys.stderr, flush=True)
    return setup


def tremor_of(report):
    for item in report["osacss"]["items"]:
        for measure in item.get("measures", []):
            if measure["id"] == "T8.tremor":
                return measure["value"]
    return None


def line_of(known, report):
    osacss = report["osacss"]
    link = report.get("link")
    tremor = tremor_of(report)
    line = {**known, "total_of_100": f"{100.0 * osacss['total'] / osacss['max']:.3f}", "completed": int(report["completed"]),
            "duration_s": f"{report['duration_s']:.2f}", "tremor_um": "" if tremor is None else f"{tremor:.2f}",
            "state_hash": report["state_hash"]}
    if link:
        line |= {"tip_off_rms_um": f"{1e3 * link['rms_mm']:.2f}", "tip_off_most_um": f"{1e3 * link['farthest_mm']:.1f}",
                 "not_seen_percent": f"{100.0 * link['unseen'] / max(1, link['present']):.4f}",
                 "stood_steps": link["stood"]}
    return line


def run(options, results, folder, known, setup):
    if Results.key(known) in results.lines:
        return
    place = folder / "-".join(str(known[field]) for field in FIELDS[:4])
    more = {"bare": [], "through": ["--through", str(setup), "--cameras", known["level"]], "moved": ["--moved", "1"]}
    report = attempts.attempt(options.rhexis, known["exercise"], known["group"], known["seed"], place, more[known["arm"]])
    line = line_of(known, report)
    results.add(line)
    if not options.keep:
        shutil.rmtree(place)
    print(f"{place.name}: {line['total_of_100']}", file=sys.stderr, flush=True)


def plan(options, exercise):
    """(seed, level, {arm: what is known of it before})."""
    for place, seed in enumerate(seeds_of(options.seeds)):
        level = "images" if place < options.images else "markers"
        yield seed, level, {arm: {"exercise": exercise, "group": options.group, "seed": seed, "arm": arm,
                                  "level": level if arm == "through" else ""} for arm in ARMS}


def spread(values):
    return statistics.stdev(values) if len(values) > 1 else math.nan


def summary(name, differences):
    return f"{name}: mean {statistics.mean(differences):+.2f}, SD {spread(differences):.2f} of 100"


def table(options, results, exercise):
    print(f"\n{exercise}\n")
    attempts.table_head(["seed", "through", "bare", "through it", "moved 1 um", "difference", "of moved", "tip off, um (RMS)",
                         "not seen, %", "trembling bare, um", "through it, um"])
    through, moved, tremor = [], [], []
    for seed, level, arms in plan(options, exercise):
        lines = {arm: results.lines.get(Results.key(known)) for arm, known in arms.items()}
        if None in lines.values():
            continue
        bare, seen, near = (float(lines[arm]["total_of_100"]) for arm in ARMS)
        through.append(seen - bare)
        moved.append(near - bare)
        trembling = [lines[arm]["tremor_um"] for arm in ("bare", "through")]
        if all(trembling):
            tremor.append(100.0 * (float(trembling[1]) / float(trembling[0]) - 1.0))
        attempts.table_row([seed, level, f"{bare:.2f}", f"{seen:.2f}", f"{near:.2f}", f"{seen - bare:+.2f}",
                            f"{near - bare:+.2f}", lines["through"]["tip_off_rms_um"],
                            lines["through"]["not_seen_percent"], *trembling])
    if not through:
        print("nothing whole yet")
        return
    print(f"\n{summary('through it', through)}; {summary('moved', moved)} (n = {len(through)})")
    if tremor:
        print(f"trembling (T8): {statistics.mean(tremor):+.1f} % on average, {max(tremor, key=abs):+.1f} % at most")


def run_all(options, results, folder):
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        waiting = []
        for exercise in options.exercises:
            todo = [known for _, _, arms in plan(options, exercise) for arm, known in arms.items()
                    if arm in options.arms and Results.key(known) not in results.lines]
            setup = rig_for(options, folder, exercise) if any(known["arm"] == "through" for known in todo) else None
            waiting += [pool.submit(run, options, results, folder, known, setup) for known in todo]
        for one in waiting:
            one.result()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--exercises", nargs="+", default=["phaco_sculpt", "capsulorhexis"])
    parser.add_argument("--group", default="d")
    parser.add_argument("--seeds", default="501-510")
    parser.add_argument("--images", type=int, default=3, help="so many seeds go through images")
    parser.add_argument("--arms", nargs="+", choices=ARMS, default=ARMS, help="run these only")
    parser.add_argument("--results", type=pathlib.Path, default=attempts.ROOT / "docs/data/tracking_chain.csv")
    parser.add_argument("--keep", type=pathlib.Path, help="folder for attempts, with recordings and reports")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--only-table", action="store_true", help="run nothing")
    parser.add_argument("--rhexis", default=attempts.PROGRAM)
    options = parser.parse_args()
    results = Results(options.results)
    if not options.only_table:
        with tempfile.TemporaryDirectory() as folder:
            run_all(options, results, (options.keep or pathlib.Path(folder)).resolve())
    for exercise in options.exercises:
        table(options, results, exercise)


if __name__ == "__main__":
    main()
