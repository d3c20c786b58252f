#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Benchmarks of this tree and of another program, in turn, as ratios.

  scripts/dev/against.py OTHER/bindings/cli/rhexis                  the default rows, 7 pairs each
  scripts/dev/against.py OTHER --rows shell_743 tear_split --pairs 9

OTHER is a rhexis that was built from another tree. Each pair runs the one right after the other, so that what else the
machine does meets both. Printed per row: the median of the ratios (above 1: this tree is faster), least and greatest, and
the median of CPU seconds per simulated second of either. Rows without that number are left out.
Exit status: 0; 1 where a program gives no such row; 2 bad usage.
"""
import argparse
import os
import re
import statistics
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
ROWS = ["implicit_lens_3000", "implicit_lens_12000", "capsule_1500", "shell_743", "tear_split"]
COST = re.compile(r"\bcpu_s_per_s ([0-9.e+-]+)")


def costs(program, row):
    """CPU seconds per simulated second of each line that the benchmark prints, by its name and place."""
    done = subprocess.run([program, "bench", row], capture_output=True, text=True, cwd=ROOT, check=False)
    if done.returncode != 0:
        sys.exit("against: " + program + " bench " + row + ": " + done.stderr.strip())
    lines = [line for line in done.stdout.splitlines() if re.match(re.escape(row) + r"[ /]", line)]
    found = {}
    for place, line in enumerate(lines):
        cost = COST.search(line)
        if cost:
            found[line.split()[0] + " " + str(place + 1)] = float(cost.group(1))
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("other", help="a rhexis built from another tree")
    parser.add_argument("--program", default=os.path.join(ROOT, "build/release/bindings/cli/rhexis"))
    parser.add_argument("--rows", nargs="+", default=ROWS)
    parser.add_argument("--pairs", type=int, default=7)
    args = parser.parse_args()
    for program in (args.other, args.program):
        if not os.access(program, os.X_OK):
            print("against: " + program + ": no program", file=sys.stderr)
            sys.exit(2)
    print("| row | times as fast | least to greatest | CPU s per s before | now |\n|---|---|---|---|---|")
    for row in args.rows:
        pairs = [(costs(args.other, row), costs(args.program, row)) for _ in range(args.pairs)]
        names = [name for name in pairs[0][0] if name in pairs[0][1]]
        if not names:
            sys.exit("against: no row " + row + " that both have")
        for name in names:
            ratios = sorted(before[name] / now[name] for before, now in pairs)
            print(f"| {name} | {statistics.median(ratios):.2f} | {ratios[0]:.2f} to {ratios[-1]:.2f} "
                  f"| {statistics.median(b[name] for b, _ in pairs):.3g} | {statistics.median(n[name] for _, n in pairs):.3g} |",
                  flush=True)


if __name__ == "__main__":
    main()
