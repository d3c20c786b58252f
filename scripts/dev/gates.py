#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pass marks for each exercise from what groups of virtual surgeons scored: between group a and group d.

  rhexis study gate_marks                                       runs/study-gate_marks/cohorts.json
  scripts/dev/gates.py rubrics/cohorts.json runs/study-gate_marks/cohorts.json      prints a table
  scripts/dev/gates.py rubrics/cohorts.json rubrics/gate_marks.json --write         and writes rubrics/gates.json

Attempts of several files are taken together; each exercise must be the same in all. docs/records.md says how a mark is
chosen.
"""

import argparse
import json
import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXPERTS, BEGINNERS = 0.9, 0.25  # shares of their attempts that are to pass; acceptance asks for 0.8 and 0.4


def together(files):
    """One cohort per exercise, of the attempts of all files."""
    pooled = {}
    for file in files:
        for exercise, cohort in json.loads(file.read_text())["exercises"].items():
            whole = pooled.setdefault(exercise, {"decides": cohort["decides"], "seeds": [], "groups": {}})
            if whole["decides"] != cohort["decides"]:
                raise SystemExit(f"gates.py: {exercise} in {file} is another exercise than in the files before it")
            first, last = cohort["seeds"]
            if {*range(first, last + 1)} & {*whole["seeds"]}:
                raise SystemExit(f"gates.py: {exercise} in {file}: seeds {first} to {last} are there already")
            whole["seeds"] += range(first, last + 1)
            for name in ("a", "d"):
                group = whole["groups"].setdefault(name, {"attempts": 0, "completed": []})
                group["attempts"] += cohort["groups"][name]["attempts"]
                group["completed"] += cohort["groups"][name]["completed"]
    return pooled


def share(group, mark):
    return sum(score >= mark for score in group["completed"]) / max(1, group["attempts"])


def gate_of(cohort):
    a, d = cohort["groups"]["a"], cohort["groups"]["d"]
    marks = [round(0.01 * i, 2) for i in range(101)]
    reached = max((mark for mark in marks if share(d, mark) >= EXPERTS), default=None)
    kept_out = min(mark for mark in marks if share(a, mark) <= BEGINNERS)
    ground = (f"seeds {min(cohort['seeds'])} to {max(cohort['seeds'])}: of {a['attempts']} attempts each, "
              f"group d completed {len(d['completed'])}, group a {len(a['completed'])}")
    if reached is None:
        best = min(d["completed"], default=0.5)
        return round(best - 0.005, 2), False, f"{ground}; too few of group d come to the end to tell them apart"
    if kept_out > reached:
        return reached, False, f"{ground}; nine of ten of group d reach {reached:.2f}, and so do too many of group a"
    mark = round(0.5 * (reached + kept_out), 2)
    return mark, True, f"{ground}; nine of ten of group d reach {reached:.2f}, a quarter of group a {kept_out:.2f}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cohorts", type=pathlib.Path, nargs="+")
    todo = parser.add_mutually_exclusive_group()
    todo.add_argument("--write", action="store_true", help="into rubrics/gates.json")
    todo.add_argument("--check", action="store_true", help="status 1 if rubrics/gates.json has other gates")
    options = parser.parse_args()
    gates = {}
    for exercise, cohort in sorted(together(options.cohorts).items()):
        mark, apart, reason = gate_of(cohort)
        gates[exercise] = {"pass": mark, **({} if apart else {"tells_apart": False}), "reason": reason}
        print(f"{exercise:28} {mark:.2f} {'' if apart else 'tells nobody apart: '}{reason}")
    blind = sum("tells_apart" in gate for gate in gates.values())
    print(f"{blind} of {len(gates)} tell nobody apart")
    path = ROOT / "rubrics" / "gates.json"
    whole = json.loads(path.read_text())
    if options.check and whole["exercises"] != gates:
        raise SystemExit(f"gates.py: {path} has other gates: --write")
    if options.write:
        whole["exercises"] = gates
        path.write_text(json.dumps(whole, indent=2, ensure_ascii=False) + "\n")


if __name__ == "__main__":
    main()
