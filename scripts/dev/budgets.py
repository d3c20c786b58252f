#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Error budgets of the exercises, held against twice the resolution on seeds that nothing was tuned on.

  scripts/dev/budgets.py                    all exercises, seeds 9321 to 9323; writes docs/data/budgets.json and the
                                            table of docs/accuracy.md; half an hour of two cores
  scripts/dev/budgets.py groove surge       only these; the others stay as they are
  scripts/dev/budgets.py --page             only the table, from docs/data/budgets.json

Each is one attempt of the exercise's expert, its first 30 simulated seconds, with --accuracy measure: what was recorded is
simulated again, and both are compared up to the first tear, crack or grip that differs.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import pages

ROOT = pathlib.Path(__file__).resolve().parents[2]
DATA = ROOT / "docs" / "data" / "budgets.json"
BEGIN, END = "<!-- budgets: written by scripts/dev/budgets.py -->", "<!-- end of budgets -->"
SEEDS = (9321, 9322, 9323)
LIMIT_S = 30


def attempt(rhexis, exercise, seed):
    """What one attempt chose, may err by and erred by; None where nothing is chosen by a budget."""
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([rhexis, "run", exercise, "--surgeon", "expert", "--seed", str(seed), "--limit",
                               str(LIMIT_S), "--accuracy", "measure", "--no-pictures", "--out", folder],
                              capture_output=True, text=True, check=False)
        report = pathlib.Path(folder) / "report.json"
        if not report.exists():
            return {"failed": (done.stderr.strip().splitlines() or ["no report"])[-1]}
        told = json.loads(report.read_text(encoding="utf-8"))
    accuracy, measured = told["accuracy"], told["accuracy"]["measured"]
    if not accuracy["models"]:
        return None
    return {
        "step_ms": round(1000 * accuracy["step_s"], 3),
        "mesh": {name: value for model in accuracy["models"] for name, value in model["mesh"].items()},
        "budget": {name: value for model in accuracy["models"] for name, value in model["budget"].items()},
        "errors": measured["errors"],
        "compared_s": measured["compared_s"],
        "of_s": measured["of_s"],
        "differs": measured["differs"]["measure"] if measured["differs"] else "",
        "cpu_s_per_s": told["performance"]["cpu_s_per_s"],
    }


def measure(rhexis, exercises):
    tasks = [(exercise, seed) for exercise in exercises for seed in SEEDS]
    found = {exercise: [] for exercise in exercises}
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for number, ((exercise, seed), one) in enumerate(
                zip(tasks, pool.map(lambda task: attempt(rhexis, *task), tasks)), 1):
            print(f"  {number} of {len(tasks)}: {exercise}, seed {seed}", file=sys.stderr)
            if one is not None:
                found[exercise].append({"seed": seed, **one})
    return {exercise: runs for exercise, runs in found.items() if runs}


def number(value):
    return f"{value:.2g}" if value < 1000 else f"{value:.0f}"


def row(exercise, runs):
    good = [run for run in runs if "failed" not in run]
    if not good:
        return f"| {exercise} | - | {runs[0]['failed']} | | | | |"
    budget = good[0]["budget"]
    errors = []
    for quantity, allowed in sorted(budget.items()):
        of_seeds = [run["errors"][quantity] for run in good if quantity in run["errors"]]
        if of_seeds:
            worst = max(of_seeds)
            errors.append(f"{quantity} {', '.join(map(number, of_seeds))}" + (" **more**" if worst > allowed else ""))
    chosen = ", ".join(f"{value:g} {name.split('.')[-1]}" if name.startswith("patient") else f"{name} {value:g}"
                       for name, value in good[0]["mesh"].items())
    compared = ", ".join(f"{run['compared_s']:.0f}" for run in good)
    cost = sum(run["cpu_s_per_s"] for run in good) / len(good)
    allowed = ", ".join(f"{name} {value:g}" for name, value in sorted(budget.items()))
    return (f"| {exercise} | {allowed} | {chosen or '-'}, {good[0]['step_ms']:g} ms | {'; '.join(errors) or '-'} | "
            f"{compared} | {', '.join(sorted({run['differs'] for run in good} - {''})) or '-'} | {cost:.2f} |")


def write_page(found):
    head = ["| exercise | error that it may have | chosen | error on the three seeds | compared, s | ended by | CPU s per s |",
            "|---|---|---|---|---|---|---|"]
    pages.write_between(ROOT / "docs" / "accuracy.md", BEGIN, END,
                        "\n" + "\n".join(head + [row(*entry) for entry in sorted(found.items())]) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("exercises", nargs="*", metavar="EXERCISE")
    parser.add_argument("--rhexis", default=str(ROOT / "build/release/bindings/cli/rhexis"), help="program to measure")
    parser.add_argument("--page", action="store_true", help="only write the table again")
    options = parser.parse_args()
    known = sorted(path.parent.name for path in (ROOT / "curricula").glob("*/curriculum.lua"))
    unknown = sorted({*options.exercises} - {*known})
    if unknown:
        sys.exit(f"budgets.py: no exercise is called {unknown[0]} (one of {', '.join(known)})")
    found = json.loads(DATA.read_text(encoding="utf-8")) if DATA.exists() else {}
    if not options.page:
        found.update(measure(options.rhexis, options.exercises or known))
        DATA.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")
    write_page(found)


if __name__ == "__main__":
    main()
