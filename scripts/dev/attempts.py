# SPDX-License-Identifier: GPL-3.0-or-later
"""Attempts by virtual surgeons, run one after the other or side by side; what study.py and random_operator.py share."""

import json
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = str(ROOT / "build" / "release" / "bindings" / "cli" / "rhexis")


def attempt(program, exercise, surgeon, seed, folder, more=()):
    """Runs one attempt without pictures; returns its report.json. `more`: further options of rhexis run."""
    command = [program, "run", exercise, "--surgeon", surgeon, "--seed", str(seed), "--no-pictures", "--out", str(folder)]
    done = subprocess.run(command + list(more), cwd=ROOT, capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(command)}: {done.stderr.strip()}")
    return json.loads((pathlib.Path(folder) / "report.json").read_text())


def series(folder):
    """Measures over time of an attempt, by name: lists of values."""
    found = json.loads((pathlib.Path(folder) / "series.json").read_text())
    return {name: measure["values"] for name, measure in found["measures"].items()}


def table_head(names):
    print("| " + " | ".join(names) + " |")
    print("|" + "---|" * len(names), flush=True)


def table_row(cells):
    print("| " + " | ".join(str(cell) for cell in cells) + " |", flush=True)
