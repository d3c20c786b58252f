#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows of `rhexis bench --json` as CSV: bench_to_csv.py FILE FIELD..."""
import csv
import json
import sys

if len(sys.argv) < 3:
    sys.exit("usage: bench_to_csv.py FILE FIELD...")
with open(sys.argv[1], encoding="utf-8") as file:
    rows = json.load(file)["cases"]
fields = sys.argv[2:]
writer = csv.writer(sys.stdout, lineterminator="\n")
writer.writerow(fields)
for row in rows:
    writer.writerow([f"{row[f]:.6g}" if isinstance(row.get(f), float) else row.get(f, "") for f in fields])
