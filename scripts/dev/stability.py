#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the stability gates in their long form, keeps what they measured and lists them in docs/stability.md.

  scripts/dev/stability.py           runs all of them
  scripts/dev/stability.py --list    only lists again what was measured before

Needs a Release build (./demo.sh makes one). Figures go to docs/data/stability.json.
"""

import argparse
import json
import os
import pathlib
import re
import subprocess
import sys

from pages import write_between

ROOT = pathlib.Path(__file__).resolve().parents[2]
DATA = ROOT / "docs/data/stability.json"
PAGE = ROOT / "docs/stability.md"
BEGIN, END = "<!-- gates: written by scripts/dev/stability.py -->\n", "<!-- end of gates -->\n"


def rhexis():
    program = os.environ.get("RHEXIS", str(ROOT / "build/release/bindings/cli/rhexis"))
    if not os.access(program, os.X_OK):
        sys.exit("rhexis: there is no Release build (./demo.sh makes one)")
    return program


def measure():
    """A gate that fails ends the command with status 1; it is listed like the others."""
    found = subprocess.run([rhexis(), "bench", "stability", "--json"], stdout=subprocess.PIPE, check=False)
    told = json.loads(found.stdout)
    DATA.write_text(json.dumps({"machine": told["machine"]["processor"], "gates": told["cases"]}, indent=1) + "\n",
                    encoding="utf-8")


def share(gate):
    """Of what it may be; a number that is none is the worst."""
    if gate["measured"] is None:
        return float("inf")
    return gate["measured"] / gate["gate"] if gate["gate"] else (0.0 if gate["passed"] else float("inf"))


def number(value):
    return "none" if value is None else f"{value:.3g}"


def case_of(gate):
    name = gate["name"].removeprefix("stability/").removeprefix(gate["group"]).strip()
    return re.sub(r"(\d\.\d+?)0+\b", r"\1", name)


def table(gates):
    """A row per measure and limit of each group, with the case that comes nearest to the limit."""
    lines = ["| | what is measured | allowed | measured, at worst | there |", "|---|---|---|---|---|"]
    for group in dict.fromkeys(gate["group"] for gate in gates):
        own = [gate for gate in gates if gate["group"] == group]
        why = f" *{own[0]['why']}*" if own[0]["why"] else ""
        lines.append(f"| **{group}** | **{own[0]['provoked']}.**{why} | | | |")
        for what, limit in dict.fromkeys((gate["what"], gate["gate"]) for gate in own):
            cases = [gate for gate in own if (gate["what"], gate["gate"]) == (what, limit)]
            worst = max(cases, key=share)
            count = f", {len(cases)} cases" if len(cases) > 1 else ""
            failed = "" if all(gate["passed"] for gate in cases) else " **fails**"
            lines.append(f"| | {what}{count} | {number(limit)} | {number(worst['measured'])}{failed} "
                         f"| {case_of(worst)} |")
    passed = sum(gate["passed"] for gate in gates)
    lines += ["", f"{len(gates)} gates, of which {passed} pass."]
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--list", action="store_true", help="only list again what was measured before")
    if not parser.parse_args().list:
        measure()
    write_between(PAGE, BEGIN, END, table(json.loads(DATA.read_text(encoding="utf-8"))["gates"]))
    print(f"{DATA.relative_to(ROOT)}, {PAGE.relative_to(ROOT)}")


if __name__ == "__main__":
    main()
