#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of `rhexis track measure --json` as CSV: tracking_csv.py FILE.json FOLDER writes tracking_figures.csv,
tracking_chart.csv (detectors, cameras, markers against compute) and tracking_levels.csv (how errors spread with images and
without)."""

import csv
import json
import pathlib
import sys


def write(path, head, rows):
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(head)
        writer.writerows(rows)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    measured = json.loads(pathlib.Path(sys.argv[1]).read_text(encoding="utf-8"))
    folder = pathlib.Path(sys.argv[2])
    fields = ["quantity", "from", "unit", "value", "mean_of_seeds", "of_worst_seed", "worst_seed", "goal", "samples"]
    write(folder / "tracking_figures.csv", fields,
          [[row.get(field, "") for field in fields] for row in measured["figures"] if row["samples"]])
    write(folder / "tracking_chart.csv",
          ["detector", "cameras", "markers", "cpu_ms", "detect_ms", "mean_um", "of_95_um", "of_999_um", "valid_percent"],
          [[row["detector"], row["cameras"], row["markers"],
            f"{1e3 * (row['detect_p50_s'] + row['track_p50_s']):.3f}", f"{1e3 * row['detect_p50_s']:.3f}",
            *(f"{1e3 * row[key]:.1f}" for key in ("mean_mm", "of_95_mm", "of_999_mm")),
            f"{100 * row['valid'] / max(1, row['frames']):.2f}"] for row in measured["chart"]])
    write(folder / "tracking_levels.csv", ["quantity", "from", "unit", "share", "within"],
          [[row["quantity"], row["from"], row["unit"], *pair] for row in measured["levels"] if row["unit"] != "%"
           for pair in row["quantiles"]])


if __name__ == "__main__":
    main()
