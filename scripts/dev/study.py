#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Attempts of virtual surgeons, seed by seed, and how far the groups are apart; prints tables.

  scripts/dev/study.py phaco_sculpt --groups d a --seeds 101-106
  scripts/dev/study.py phaco_sculpt --groups a --seeds 101-120 --jobs 2 --set surgeon.recovery=0
  scripts/dev/study.py phaco_sculpt --groups d a --seeds 101-106 --keep FOLDER    an attempt that is in FOLDER is not run again
  scripts/dev/study.py capsulorhexis --item T5    its measures, and how many attempts have five points for each of them

Seeds from 9000 on are kept for acceptance: they are not run while anything is tuned.
"""

import argparse
import concurrent.futures
import json
import pathlib
import statistics
import sys
import tempfile

import attempts


def seeds_of(text):
    first, _, last = text.partition("-")
    return list(range(int(first), int(last or first) + 1))


def one(options, folder, group, seed):
    place = folder / f"{options.exercise}-{group}-{seed}"
    kept = place / "report.json"
    if kept.exists():
        return json.loads(kept.read_text())
    more = [word for setting in options.set for word in ("--set", setting)]
    return attempts.attempt(options.rhexis, options.exercise, group, seed, place, more)


def events_of(report):
    counts = {}
    for event in report["events"]:
        raised, recovered = counts.get(event["title"], (0, 0))
        counts[event["title"]] = (raised + 1, recovered + (1 if event["recovered"] else 0))
    return ", ".join(f"{title} {raised} ({recovered})" for title, (raised, recovered) in counts.items()) or "none"


def item_of(report, name):
    """Score of an item and its judged measures, {id: (value, score)}; None and {} where it was not scored."""
    for item in report["osacss"]["items"]:
        if item["id"] == name:
            return item.get("score"), {m["id"]: (m["value"], m["score"]) for m in item["measures"]}
    return None, {}


def item_summary(group, reports, name):
    judged = [item_of(report, name) for report in reports]
    scores = [score for score, _ in judged if score is not None]
    full = sum(1 for _, measures in judged if measures and all(points >= 5 for _, points in measures.values()))
    median = f"{statistics.median(scores):.2f}" if scores else "none"
    print(f"{group}: {name} median {median} of 5; five points for each of its measures in {full} of {len(reports)}")


def print_item(group, reports, options):
    judged = [item_of(report, options.item) for report in reports]
    names = sorted({name for _, measures in judged for name in measures})
    print()
    attempts.table_head(["surgeon", "seed", options.item, *names])
    for seed, (score, measures) in zip(options.seeds, judged):
        cells = [f"{measures[name][0]:.3f}" if name in measures else "-" for name in names]
        attempts.table_row([group, seed, "-" if score is None else f"{score:.2f}", *cells])
    print()
    item_summary(group, reports, options.item)


def row(group, seed, report, place, shown):
    last = {name: values[-1] for name, values in attempts.series(place).items()}
    cells = [f"{last[name]:.2f}" if isinstance(last.get(name), float) else "-" for name in shown]
    performance = report["performance"]
    return [group, seed, "yes" if report["completed"] else "no", f"{report['duration_s']:.0f} s",
            f"{100 * report['osacss']['scaled']:.1f}", events_of(report), *cells, f"{performance['cpu_s_per_s']:.2f}",
            performance["rollbacks"]]


def summary(group, reports):
    events = [event for report in reports for event in report["events"]]
    erring = sum(1 for report in reports if report["events"])
    recovered = sum(1 for event in events if event["recovered"])
    scores = [100 * report["osacss"]["scaled"] for report in reports]
    share = f"{recovered} of {len(events)} put right" if events else "none"
    print(f"{group}: {len(reports)} attempts, {sum(r['completed'] for r in reports)} completed, {erring} with errors, "
          f"errors {share}; OSACSS {min(scores):.1f} to {max(scores):.1f}, median {statistics.median(scores):.1f} of 100")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("exercise")
    parser.add_argument("--groups", nargs="+", default=["d", "a"])
    parser.add_argument("--seeds", type=seeds_of, default=seeds_of("101-103"))
    parser.add_argument("--set", action="append", default=[], metavar="NAME=VALUE")
    parser.add_argument("--show", nargs="*", default=[], metavar="MEASURE", help="at the end of each attempt")
    parser.add_argument("--item", help="of the rubric: its measures, as judged")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--keep", type=pathlib.Path, help="folder for the attempts")
    parser.add_argument("--rhexis", default=attempts.PROGRAM)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        folder = options.keep or pathlib.Path(scratch)
        attempts.table_head(["surgeon", "seed", "completed", "time", "OSACSS of 100", "errors (put right)", *options.show,
                             "CPU s per s", "steps redone"])
        reports = {}
        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            for group in options.groups:
                done = pool.map(lambda seed: one(options, folder, group, seed), options.seeds)
                for seed, report in zip(options.seeds, done):
                    reports.setdefault(group, []).append(report)
                    place = folder / f"{options.exercise}-{group}-{seed}"
                    attempts.table_row(row(group, seed, report, place, options.show))
        print()
        for group, found in reports.items():
            summary(group, found)
            if options.item:
                print_item(group, found, options)
    return 0


if __name__ == "__main__":
    sys.exit(main())
