#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Charts of speed against accuracy: measures them, keeps their figures, draws them and lists them in docs/accuracy.md.

  scripts/dev/charts.py              all of them
  scripts/dev/charts.py chamber      those named
  scripts/dev/charts.py --draw       only draw and list again what was measured before
  scripts/dev/charts.py --list       name them

Needs a Release build (./demo.sh makes one) and, to draw, the Debian package gnuplot-nox. Figures go to
docs/data/charts/NAME.csv, pictures to docs/pictures/charts/NAME.svg.
"""

import argparse
import csv
import io
import json
import math
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

from pages import write_between

ROOT = pathlib.Path(__file__).resolve().parents[2]
DATA = ROOT / "docs/data/charts"
PICTURES = ROOT / "docs/pictures/charts"
PAGE = ROOT / "docs/accuracy.md"
BEGIN, END = "<!-- charts: written by scripts/dev/charts.py -->\n", "<!-- end of charts -->\n"
FIELDS = ["way", "setting", "default", "cost", "error", "failure"]
COLOURS = ["#1b9e5a", "#4a90d9", "#e08214", "#7a5195", "#888888", "#b0632a", "#d4608f", "#3d7f86"]
TRACKING = {  # measured by the program that tracks, not by `rhexis bench`, which loads no camera's libraries
    "chart": "tracking",
    "title": "Tips of tracked instruments, at rest, by ways to find spots, cameras and markers (seed 301)",
    "cost": "CPU seconds for one exposure",
    "error": "tip, 95 % within, share of 1 mm",
    "answer": "the synthetic rig: what stood before its cameras is known exactly (docs/tracking.md)",
    "outside": False,
}
REAL_TIME = "CPU seconds per simulated second"
YARDSTICK = "product/3000"  # a row of the benchmark "product", measured in the same run


def rhexis():
    program = os.environ.get("RHEXIS", str(ROOT / "build/release/bindings/cli/rhexis"))
    if not os.access(program, os.X_OK):
        sys.exit("rhexis: there is no Release build (./demo.sh makes one)")
    return program


def known():
    told = json.loads(subprocess.run([rhexis(), "bench", "--list", "--json"], capture_output=True, check=True).stdout)
    charts = {entry["about"]["chart"]: entry["about"] for entry in told if "about" in entry}
    return charts | {TRACKING["chart"]: TRACKING}


def told_by(*command):
    done = subprocess.run([rhexis(), *command, "--json"], stdout=subprocess.PIPE, check=True)
    return json.loads(done.stdout)


def tracking_rows():
    for row in told_by("track", "measure", "--chart", "--first-seed", "301")["chart"]:
        if row["markers"] == 4 or row["detector"] == "fitted outlines":
            yield {"name": f"{row['detector']}, {row['markers']} markers", "setting": f"{row['cameras']} cameras",
                   "default": (row["detector"], row["cameras"], row["markers"]) == ("fitted outlines", 6, 4),
                   "cost": row["detect_p50_s"] + row["track_p50_s"], "error": row["of_95_mm"]}


def measure(about):
    began = time.time()
    told = told_by("bench", *([] if about is TRACKING else ["chart_" + about["chart"]]), "product")
    unit = next(row for row in told["cases"] if row["name"] == YARDSTICK)
    rows = [row for row in told["cases"] if not row["name"].startswith("product/")]
    rows = list(tracking_rows()) if about is TRACKING else rows
    text = io.StringIO()
    for key in ("title", "cost", "error", "answer"):
        print(f"# {key}: {about[key]}", file=text)
    print(f"# outside: {'yes' if about['outside'] else 'no'}", file=text)
    print(f"# machine: {told['machine']['processor']}", file=text)
    print(f"# yardstick: {unit['us']:.1f} us for one product over {unit['elements']:,} tetrahedra", file=text)
    print(f"# minutes: {(time.time() - began) / 60:.1f}", file=text)
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(FIELDS)
    for row in rows:
        writer.writerow([row["name"], row["setting"], "yes" if row.get("default") else "", f"{row['cost']:.4g}",
                         f"{row['error']:.6g}" if "error" in row else "", row.get("failure", "")])
    DATA.mkdir(parents=True, exist_ok=True)
    (DATA / (about["chart"] + ".csv")).write_text(text.getvalue(), encoding="utf-8")


def read(path):
    lines = path.read_text(encoding="utf-8").splitlines()
    chart = dict(line[2:].split(": ", 1) for line in lines if line.startswith("# "))
    chart["name"] = path.stem
    chart["rows"] = list(csv.DictReader(line for line in lines if not line.startswith("# ")))
    return chart


def default_of(chart):
    return next(row for row in chart["rows"] if row["default"])


def quoted(text):
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def labelled(points, width, height):
    """Points whose labels would lie on one another share one: (cost, error, label)."""
    def near(one, other, span):
        return one > 0 and other > 0 and abs(math.log(one / other)) < span

    groups = []
    for cost, error, row in points:
        if groups and near(cost, groups[-1][0], 0.02 * width) and near(error, groups[-1][1], 0.03 * height):
            groups[-1][2].append(row["setting"])
        else:
            groups.append((cost, error, [row["setting"]]))
    return [(cost, error, settings[0] if len(settings) == 1 else f"{settings[0]} to {settings[-1]}")
            for cost, error, settings in groups]


def draw(chart):
    least = 1e-5  # of an error, in per cent: what is less is drawn there
    errors = [max(least, 100 * float(row["error"])) for row in chart["rows"] if row["error"]]
    top = 3 * max(errors + [1.0])
    commands = [
        'set terminal svg size 560,400 font "sans,11" background "white"',
        f"set output {quoted(str(PICTURES / (chart['name'] + '.svg')))}",
        "set logscale xy", 'set grid xtics ytics lc rgb "#dddddd"', "set format y '%g'", "set format x '%g'",
        "set key above maxrows 3 font ',9'", f"set title {quoted(chart['title'])} font ',11'",
        f"set xlabel {quoted(chart['cost'])}", f"set ylabel {quoted(chart['error'] + ' [%]')}",
        f"set yrange [{min(errors) / 2:g}:{top:g}]"]
    costs = [float(row["cost"]) for row in chart["rows"] if float(row["cost"]) > 0]
    low, high = min(costs) / 2, max(costs) * 3
    if chart["cost"] == REAL_TIME and low < 1 < high:
        commands.append('set arrow from 1, graph 0 to 1, graph 1 nohead lc rgb "#c03030" lw 1.5')
    commands.append(f"set xrange [{low:g}:{high:g}]")
    plots = []
    for number, way in enumerate(dict.fromkeys(row["way"] for row in chart["rows"])):
        colour = COLOURS[number % len(COLOURS)]
        points = [(float(row["cost"]), max(least, 100 * float(row["error"])) if row["error"] else top / 1.3, row)
                  for row in chart["rows"] if row["way"] == way]
        block = f"$way{number}"
        commands.append(f"{block} << EOD")
        commands += [f"{cost:g} {error:g}" for cost, error, row in points]
        commands += ["EOD", f"$label{number} << EOD"]
        commands += [f"{cost:g} {error:g} {quoted(label)}" for cost, error, label in
                     labelled(points, math.log(high / low), math.log(2 * top / min(errors)))]
        commands.append("EOD")
        plots.append(f"{block} using 1:2 with linespoints lc rgb '{colour}' pt 7 ps 0.6 lw 2 title {quoted(way)}")
        plots.append(f"$label{number} using 1:2:3 with labels left offset 0.7,0.5 font ',8' tc rgb '{colour}' notitle")
        for cost, error, row in points:
            if row["default"]:
                commands += ["$default << EOD", f"{cost:g} {error:g}", "EOD"]
    plots.append("$default using 1:2 with points pt 6 ps 2 lw 2 lc rgb 'black' title 'default'")
    commands.append("plot " + ", ".join(plots))
    PICTURES.mkdir(parents=True, exist_ok=True)
    with tempfile.NamedTemporaryFile("w", suffix=".gp", encoding="utf-8") as script:
        script.write("\n".join(commands) + "\n")
        script.flush()
        subprocess.run(["gnuplot", script.name], check=True)


def percent(share):
    return f"{100 * float(share):.2g} %"


def measured_on(charts):
    """Machines, and what the yardstick took on them while charts were measured."""
    lines = []
    for machine in dict.fromkeys(chart["machine"] for chart in charts):
        told = [chart["yardstick"] for chart in charts if chart["machine"] == machine and "yardstick" in chart]
        took = sorted(float(text.split()[0]) for text in told)
        if took:
            what = told[0].split(" for one ", 1)[1]
            lines += [f"Measured on one core of: {machine}. One scalar double matrix-free {what} (`rhexis bench product`) "
                      f"took {took[0]:g} to {took[-1]:g} us in the same runs; files measured with it say what it took in their own.", ""]
    return lines


def table(charts):
    lines = ["| | model | the default | answer | minutes |", "|---|---|---|---|---|"]
    for chart in charts:
        row = default_of(chart)
        place = f"charts/{chart['name']}.svg"
        unit = "CPU s per s" if chart["cost"] == REAL_TIME else chart["cost"]
        whose = chart["answer"] if chart["outside"] == "yes" else "ours: " + chart["answer"]
        lines.append(f'| [<img src="pictures/{place}" width="240" alt="{chart["title"]}">](pictures/{place}) '
                     f"| **{chart['name']}**: {chart['title']} ([data](data/charts/{chart['name']}.csv)) "
                     f"| {row['way']}, {row['setting']}: {percent(row['error'])}, {float(row['cost']):.2g} {unit} "
                     f"| {whose} | {chart['minutes']} |")
    outside = sum(chart["outside"] == "yes" for chart in charts)
    lines = measured_on(charts) + lines
    lines.append("")
    lines.append(f"{len(charts)} models, of which {outside} are held against an answer that is not ours.")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("name", nargs="*")
    parser.add_argument("--draw", action="store_true", help="only draw and list again what was measured before")
    parser.add_argument("--list", action="store_true", help="name them")
    given = parser.parse_args()
    if given.list or not given.draw:
        charts = known()
        for name in given.name:
            if name not in charts:
                sys.exit(f"rhexis: there is no chart {name}; there are: {', '.join(charts)}")
        if given.list:
            print("\n".join(f"{name:<24} {about['title']}" for name, about in charts.items()))
            return
    if shutil.which("gnuplot") is None:
        sys.exit("rhexis: charts are drawn by gnuplot; the Debian package gnuplot-nox has it")
    if not given.draw:
        wanted = [about for name, about in charts.items() if not given.name or name in given.name]
        for number, about in enumerate(wanted, 1):
            print(f"[{number}/{len(wanted)}] {about['chart']}: {about['title']}", flush=True)
            measure(about)
    drawn = [read(path) for path in sorted(DATA.glob("*.csv"))]
    for chart in drawn:
        if not given.name or chart["name"] in given.name:
            draw(chart)
    write_between(PAGE, BEGIN, END, table(drawn))
    print(f"{DATA.relative_to(ROOT)}, {PICTURES.relative_to(ROOT)}, {PAGE.relative_to(ROOT)}")


if __name__ == "__main__":
    main()
