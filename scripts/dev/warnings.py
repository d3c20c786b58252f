#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How often a warning came in time, and how often for nothing.

  scripts/dev/warnings.py                       the scenarios of studies/warnings that set no limit ("held out")
  scripts/dev/warnings.py --set tuning          those that limits were chosen by
  scripts/dev/warnings.py --results FILE...     of rhexis test --results, made before
  scripts/dev/warnings.py --reports FOLDER...   of attempts: report.json of each folder

Per rule of scripts/theatre/warnings.lua: scenarios, how often what it warns of came, how often that was warned of at
least one second before, false alarms (nothing came within 10 s) in all and at most in one scenario.
Exit status: 0, or 2 for bad usage or bad input.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
IN_TIME_S = 1.0


def fail(text):
    print("warnings: " + text, file=sys.stderr)
    sys.exit(2)


def play(given, file):
    with tempfile.TemporaryDirectory() as folder:
        results = os.path.join(folder, "results.json")
        words = [given.program, "test", file, "--filter", given.set, "--results", results]
        if given.jobs:
            words += ["--jobs", str(given.jobs)]
        done = subprocess.run(words, cwd=ROOT, check=False, stdout=subprocess.DEVNULL)
        if not os.path.exists(results):
            fail(f"rhexis test {file} ended with {done.returncode}")
        with open(results, encoding="utf-8") as opened:
            return json.load(opened)


def read(path):
    try:
        with open(path, encoding="utf-8") as file:
            return json.load(file)
    except (OSError, ValueError) as error:
        return fail(f"{path}: {error}")


def tell(name, attempts):
    """attempts: list of (title, found)."""
    rules = {}
    for title, found in attempts:
        found = found or {}
        for one in found.get("foreseen", []):
            rule = rules.setdefault(one["id"], {"came": 0, "in_time": 0, "leads": [], "false": {}, "missed": []})
            rule["came"] += 1
            lead = one.get("warned_s")
            rule["leads"].append(lead)
            if lead is not None and lead >= IN_TIME_S - 1e-9:
                rule["in_time"] += 1
            else:
                rule["missed"].append((title, lead))
        for one in found.get("warnings", []):
            rule = rules.setdefault(one["id"], {"came": 0, "in_time": 0, "leads": [], "false": {}, "missed": []})
            if "came_s" not in one:
                rule["false"][title] = rule["false"].get(title, 0) + 1
    print(f"{name}: {len(attempts)} attempts")
    for rule, of in sorted(rules.items()):
        share = f"{100 * of['in_time'] / of['came']:.0f} %" if of["came"] else "-"
        false = sum(of["false"].values())
        leads = sorted(lead for lead in of["leads"] if lead is not None)
        median = f", {leads[len(leads) // 2]:.2f} s ahead in the middle" if leads else ""
        print(f"  {rule}: came {of['came']}, warned of 1 s ahead {of['in_time']} ({share}){median}; false alarms {false}"
              f" ({false / len(attempts):.2f} an attempt, at most {max(of['false'].values(), default=0)})")
        for title, lead in of["missed"][:given_misses]:
            print(f"    {title}: " + (f"{lead:.2f} s ahead" if lead is not None else "not warned of"))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--set", default="held out", choices=["held out", "tuning"])
    parser.add_argument("--results", nargs="+")
    parser.add_argument("--reports", nargs="+")
    parser.add_argument("--program", default=os.path.join(ROOT, "build", "release", "bindings", "cli", "rhexis"))
    parser.add_argument("--jobs", type=int, default=0)
    parser.add_argument("--misses", type=int, default=0, help="show so many that were missed")
    given = parser.parse_args()
    global given_misses
    given_misses = given.misses
    if given.reports:
        tell("reports", [(path, read(os.path.join(path, "report.json"))) for path in given.reports])
        return
    if given.results:
        for path in given.results:
            tell(path, [(one["name"], one["found"]) for one in read(path)])
        return
    folder = os.path.join(ROOT, "studies", "warnings")
    for file in sorted(os.listdir(folder)):
        if file.endswith(".lua"):
            tell(file[:-4], [(one["name"], one["found"]) for one in play(given, os.path.join(folder, file))])


if __name__ == "__main__":
    main()
