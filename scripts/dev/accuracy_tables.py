#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables by which rhexis chooses mesh, step and way from an error budget: assets/accuracy/NAME.csv, from charts.

  scripts/dev/accuracy_tables.py                 all of them, from the charts that are kept in docs/data
  scripts/dev/accuracy_tables.py lens            those named
  scripts/dev/accuracy_tables.py --measure       measure the charts again before (some minutes each)
  scripts/dev/accuracy_tables.py --check         whether the tables are what the charts give; status 1 if not
  scripts/dev/accuracy_tables.py --list          name them, with the chart that each is from

To measure needs a Release build (./demo.sh makes one) and a machine that does nothing else: costs are CPU time of one
thread. Errors are the same on every machine. The form of a table: kernel/session/accuracy_table.hpp.
"""

import argparse
import csv
import io
import json
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
DATA = ROOT / "docs/data"
TABLES = ROOT / "assets/accuracy"
VERSION = 1
CHARTS_MACHINE = "AMD EPYC with AVX-512"  # docs/accuracy.md


def chart(name):
    lines = (DATA / name).read_text(encoding="utf-8").splitlines()
    return [row for row in csv.DictReader(line for line in lines if not line.startswith("#")) if not row.get("failure")]


def wanted(elements, sizes):
    """What a mesh of so many elements was asked for: a mesh has about as many as are wanted."""
    nearest = min(sizes, key=lambda size: abs(size - elements))
    if abs(nearest - elements) > 0.05 * nearest:
        sys.exit(f"rhexis: a mesh of {elements} elements is of none of the sizes {sizes}")
    return nearest


def milliseconds(text):
    return float(text.removesuffix(" ms"))


def lens():
    ways = {"explicit": ("explicit", ""), "implicit, no chamber": ("implicit", "chamber")}
    for row in chart("phaco_chart.csv"):
        if row["name"] not in ways:
            continue
        way, not_with = ways[row["name"]]
        yield {"way": way, "not_with": not_with,
               "patient.tetrahedra": wanted(int(row["elements"]), [500, 1000, 1500, 2000, 3000, 4500, 6000, 12000, 24000]),
               "step_ms": milliseconds(row["point"]), "cost": row["cpu_s_per_s"], "volume": row["removed_error"],
               "force": row["force_error"], "depth": row["depth_error"]}


def anterior_capsule():
    rows = chart("capsule_chart.csv")
    finest = next(row for row in rows if row["name"] == "finest")
    torn = float(finest["torn_mm"])
    for row in rows:
        if row["name"] not in ("mesh", "mesh, 20 ms", "step") or float(row["step_ms"]) > 20:
            continue
        yield {"capsule.triangles": wanted(int(row["elements"]), [400, 750, 1000, 1500, 3000, 6000]),
               "step_ms": row["step_ms"], "cost": row["cpu_s_per_s"], "force": row["error"], "path": row["path_mm"],
               "tear": f"{abs(float(row['torn_mm']) - torn) / torn:.6g}"}


def implant():
    for row in chart("implant_bag.csv"):
        yield {"implant.triangles": row["implant"], "bag.triangles": row["bag"], "step_ms": row["step_ms"],
               "cost": row["cpu_s_per_s"], "overlap": row["deepest"], "balance": row["residual"]}


def chamber():
    for row in chart("charts/chamber.csv"):
        if row["way"] == "two stages, implicit (kernel)":
            yield {"step_ms": milliseconds(row["setting"]), "cost": row["cost"], "pressure": row["error"]}


MODELS = {
    "anterior_capsule": (anterior_capsule, "capsule_chart.csv", "6,144 triangles in steps of 2.5 ms",
                         ["scripts/dev/capsule_chart.sh"]),
    "chamber": (chamber, "charts/chamber.csv", "the matrix exponential of two linear tanks (closed form)",
                ["scripts/dev/charts.py", "chamber"]),
    "implant": (implant, "implant_bag.csv", "none: what presses and is out of balance is told as it is", None),
    "lens": (lens, "phaco_chart.csv", "24,000 tetrahedra in steps of 1 ms", ["scripts/dev/phaco_chart.sh"]),
}


def measure_implant():
    program = os.environ.get("RHEXIS", str(ROOT / "build/release/bindings/cli/rhexis"))
    found = subprocess.run([program, "bench", "implant_bag", "--json"], stdout=subprocess.PIPE, check=True)
    fields = ["bag", "implant", "step_ms", "elements", "cpu_s_per_s", "deepest", "residual", "x_mm", "y_mm", "z_mm",
              "rim_stretch", "iterations_p50", "iterations_p99"]
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(fields)
    for row in json.loads(found.stdout)["cases"]:
        writer.writerow([f"{row[f]:.6g}" if isinstance(row[f], float) else row[f] for f in fields])
    (DATA / "implant_bag.csv").write_text(text.getvalue(), encoding="utf-8")


def table(name):
    make, source, answer, _ = MODELS[name]
    rows = list(make())
    text = io.StringIO()
    print(f"# rhexis accuracy table {VERSION}", file=text)
    print(f"# answer: {answer}", file=text)
    print(f"# machine: {CHARTS_MACHINE}", file=text)
    print(f"# made by scripts/dev/accuracy_tables.py from docs/data/{source}", file=text)
    writer = csv.DictWriter(text, list(rows[0]), lineterminator="\n")
    writer.writeheader()
    for row in rows:
        writer.writerow({key: f"{value:g}" if isinstance(value, float) else value for key, value in row.items()})
    return text.getvalue()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("name", nargs="*")
    parser.add_argument("--measure", action="store_true", help="measure the charts again before")
    parser.add_argument("--check", action="store_true", help="only tell whether the tables are what the charts give")
    parser.add_argument("--list", action="store_true", help="name them")
    given = parser.parse_args()
    for name in given.name:
        if name not in MODELS:
            sys.exit(f"rhexis: there is no table {name}; there are: {', '.join(MODELS)}")
    if given.list:
        print("\n".join(f"{name:<18} docs/data/{source}" for name, (_, source, _, _) in MODELS.items()))
        return
    status = 0
    for name in given.name or MODELS:
        if given.measure:
            print(f"{name}: measuring {MODELS[name][1]}", flush=True)
            command = MODELS[name][3]
            if command:
                subprocess.run([str(ROOT / command[0]), *command[1:]], check=True)
            else:
                measure_implant()
        text, path = table(name), TABLES / f"{name}.csv"
        if not given.check:
            TABLES.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
            print(path.relative_to(ROOT))
        elif not path.exists() or path.read_text(encoding="utf-8") != text:
            print(f"rhexis: {path.relative_to(ROOT)} is not what docs/data/{MODELS[name][1]} gives: "
                  "scripts/dev/accuracy_tables.py makes it", file=sys.stderr)
            status = 1
    sys.exit(status)


if __name__ == "__main__":
    main()
