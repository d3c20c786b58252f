#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a tracking system changes in a score: the same surgeon and seed with bare hands, with hands as a rig of cameras
sees them (rhexis run --through), and with hands moved by 1 um, which shows how much of a difference is chance.

  scripts/dev/chain_study.py --keep FOLDER                         both exercises, seeds 501 to 510; hours
  scripts/dev/chain_study.py --keep FOLDER --exercises phaco_sculpt --seeds 501-503 --images 0
  scripts/dev/chain_study.py --keep FOLDER --only-table            of what is there

An attempt that is whole in FOLDER is not run again, so a study that was ended goes on. The first --images seeds go
through rendered images, the others through markers alone. Prints tables; needs `ninja -C build/release`.
"""

import argparse
import concurrent.futures
import json
import math
import pathlib
import shutil
import statistics
import subprocess
import sys

import attempts
from study import seeds_of

ARMS = ("bare", "through", "moved")


def rig_for(options, exercise):
    """A calibrated rig whose bodies are those of the exercise."""
    folder = options.keep / f"rig-{exercise}"
    setup = folder / "track.json"
    if not (folder / "calibration.html").exists():
        shutil.rmtree(folder, ignore_errors=True)
        for command in (["begin", str(folder), "--exercise", exercise], ["calibrate", str(setup)]):
            done = subprocess.run([options.rhexis, "track", *command], cwd=attempts.ROOT, capture_output=True, text=True)
            if done.returncode != 0:
                raise SystemExit(done.stderr.strip())
            print(done.stdout.strip(), file=sys.stderr, flush=True)
    return setup


def attempt(options, exercise, seed, arm, setup, level):
    folder = options.keep / exercise / f"{seed}-{arm}{'-' + level if arm == 'through' else ''}"
    report = folder / "report.json"
    if report.exists():
        return json.loads(report.read_text())
    if options.only_table:
        return None
    shutil.rmtree(folder, ignore_errors=True)
    more = {"bare": [], "through": ["--through", str(setup), "--cameras", level], "moved": ["--moved", "1"]}[arm]
    folder.parent.mkdir(parents=True, exist_ok=True)
    found = attempts.attempt(options.rhexis, exercise, options.group, seed, folder, more)
    print(f"{exercise} {seed} {arm}: {hundredths(found)}", file=sys.stderr, flush=True)
    return found


def hundredths(report):
    """The total, of 100."""
    osacss = report["osacss"]
    return 100.0 * osacss["total"] / osacss["max"]


def tremor_of(report):
    for item in report["osacss"]["items"]:
        for measure in item.get("measures", []):
            if measure["id"] == "T8.tremor":
                return measure["value"]
    return None


def spread(values):
    return statistics.stdev(values) if len(values) > 1 else math.nan


def table(exercise, rows):
    print(f"\n{exercise}\n")
    attempts.table_head(["seed", "level", "bare", "through", "moved 1 um", "through - bare", "moved - bare",
                         "tip off, um (RMS)", "not seen, %", "trembling bare, um", "through, um"])
    through, moved, tremor = [], [], []
    for seed, level, reports in rows:
        bare, seen, near = (hundredths(reports[arm]) for arm in ARMS)
        through.append(seen - bare)
        moved.append(near - bare)
        trembling = [tremor_of(reports[arm]) for arm in ("bare", "through")]
        if None not in trembling and trembling[0] > 0:
            tremor.append(100.0 * (trembling[1] / trembling[0] - 1.0))
        link = reports["through"]["link"]
        attempts.table_row([seed, level, f"{bare:.2f}", f"{seen:.2f}", f"{near:.2f}", f"{seen - bare:+.2f}",
                            f"{near - bare:+.2f}", f"{1e3 * link['rms_mm']:.0f}",
                            f"{100.0 * link['unseen'] / max(1, link['present']):.3f}",
                            *("" if value is None else f"{value:.1f}" for value in trembling)])
    if not rows:
        print("nothing whole yet")
        return
    print(f"\nthrough - bare: mean {statistics.mean(through):+.2f}, SD {spread(through):.2f} of 100; moved - bare: "
          f"mean {statistics.mean(moved):+.2f}, SD {spread(moved):.2f} (n = {len(rows)})")
    if tremor:
        print(f"trembling (T8): {statistics.mean(tremor):+.1f} % on average, {max(tremor, key=abs):+.1f} % at most")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--exercises", nargs="+", default=["phaco_sculpt", "capsulorhexis"])
    parser.add_argument("--group", default="d")
    parser.add_argument("--seeds", default="501-510")
    parser.add_argument("--images", type=int, default=3, help="so many seeds go through images")
    parser.add_argument("--arms", nargs="+", choices=ARMS, default=ARMS, help="run these only")
    parser.add_argument("--keep", type=pathlib.Path, required=True, help="folder of attempts")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--only-table", action="store_true", help="run nothing")
    parser.add_argument("--rhexis", default=attempts.PROGRAM)
    options = parser.parse_args()
    options.keep = options.keep.resolve()
    options.keep.mkdir(parents=True, exist_ok=True)
    seeds = seeds_of(options.seeds)
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        waiting = []
        for exercise in options.exercises:
            needs_rig = "through" in options.arms and not options.only_table
            setup = rig_for(options, exercise) if needs_rig else None
            for place, seed in enumerate(seeds):
                level = "images" if place < options.images else "markers"
                runs = {arm: pool.submit(attempt, options, exercise, seed, arm, setup, level) for arm in options.arms}
                waiting.append((exercise, seed, level, runs))
        for exercise in options.exercises:
            rows = [(seed, level, {arm: one.result() for arm, one in runs.items()})
                    for of, seed, level, runs in waiting if of == exercise]
            table(exercise, [row for row in rows if all(row[2].get(arm) for arm in ARMS)])


if __name__ == "__main__":
    main()
