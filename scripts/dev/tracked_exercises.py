#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every exercise operated over the network: what a virtual surgeon did, told to rhexis run --input.

  scripts/dev/tracked_exercises.py                    those that are quick first; again to go on where it stopped
  scripts/dev/tracked_exercises.py groove incision    these
  scripts/dev/tracked_exercises.py --out runs/tracked --minutes 30
  scripts/dev/tracked_exercises.py --out runs/coarse --set patient.tetrahedra=500    where the computer is slow

Each exercise of curricula/ is done by the surgeon and seed of one of its recordings/*.json (group d if there is one),
told by rhexis vrpn serve and done again by rhexis run --input vrpn://, one exercise at a time and by the wall clock:
nothing else should run. What was done already is not done again, but for what was slower than the clock by more than
--again percent. Prints a table, also to OUT/table.md.
Exit status: 0 every exercise that was done came through, 1 one did not, 2 bad usage.
"""
import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys
import time

import attempts

SERVED = re.compile(r"^at [0-9.]+:(\d+): ")
NAMES = ["exercise", "simulated", "CPU, of real time", "score told", "score by `--input`", "errors told", "by `--input`",
         "slower than the clock", "stood"]


def fail(text):
    print("tracked_exercises: " + text, file=sys.stderr)
    sys.exit(2)


def exercises(only):
    """Who does what, the short ones first."""
    found = []
    for folder in sorted((attempts.ROOT / "curricula").iterdir()):
        if "operation {" in (folder / "curriculum.lua").read_text():
            continue  # its parts are exercises
        given = [json.loads(path.read_text()) for path in sorted(folder.glob("recordings/*.json"))]
        given = [one for one in given if not one.get("level") and not one.get("start")]
        given.sort(key=lambda one: one["surgeon"] != "d")
        if given and (not only or folder.name in only):
            found.append((given[0]["expected"]["duration_s"], folder.name, given[0]))
    missing = set(only) - {name for _, name, _ in found}
    if missing:
        fail(f"no exercise with a recording that is expected: {', '.join(sorted(missing))}")
    return sorted(found, key=lambda one: one[:2])


def options_of(given):
    return [text for key, value in given.get("set", {}).items() for text in ("--set", f"{key}={value}")]


def told(program, name, given, folder):
    if (folder / "report.json").exists():
        return json.loads((folder / "report.json").read_text())
    shutil.rmtree(folder, ignore_errors=True)  # of a run that was cut short
    return attempts.attempt(program, name, given["surgeon"], given["seed"], folder, options_of(given))


def slowed_percent(report):
    return 100 * report["performance"].get("live", {}).get("slowed_share", 0)


def came(program, name, given, recording, folder, transport, again):
    """By --input; the report, and what was said meanwhile."""
    said = folder.with_suffix(".said")
    if (folder / "report.json").exists() and said.exists():
        report = json.loads((folder / "report.json").read_text())
        if slowed_percent(report) <= again:
            return report, said.read_text()
    shutil.rmtree(folder, ignore_errors=True)
    with subprocess.Popen([program, "vrpn", "serve", str(recording), "--port", "0"], stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, text=True, cwd=attempts.ROOT) as server:
        port = SERVED.match(server.stdout.readline())
        if not port:
            raise RuntimeError("nothing is told")
        command = [program, "run", name, "--seed", str(given["seed"]), "--no-pictures", "--input",
                   f"{transport}://127.0.0.1:{port[1]}", "--give-up", "5", "--out", str(folder)]
        done = subprocess.run(command + options_of(given), cwd=attempts.ROOT, capture_output=True, text=True)
        server.kill()
    if done.returncode != 0:
        raise RuntimeError(done.stderr.strip().splitlines()[-1] if done.stderr.strip() else str(done.returncode))
    said.write_text(done.stderr)
    return json.loads((folder / "report.json").read_text()), done.stderr


def score(report):
    result = report.get("osacss") or {}
    return f"{result['total']:.2f} of {result['max']:g}" if result else "-"


def row_of(name, given, before, after, said):
    stood = [line.split("the clock stands: ")[1] for line in said.splitlines() if "the clock stands: " in line]
    # the first is that nothing was heard yet, the last that the recording is at its end
    stood = [text for text in stood if not text.startswith(("no pose has come", "no instrument is seen"))]
    ends = "" if after["completed"] or not before["completed"] else " (not completed)"
    return [name if given["surgeon"] == "d" else f"{name} (group {given['surgeon']})", f"{before['duration_s']:.0f} s", f"{100 * before['performance']['cpu_s_per_s']:.0f} %", score(before),
            score(after) + ends, len(before["events"]), len(after["events"]),
            f"{slowed_percent(after):.0f} %", "; ".join(dict.fromkeys(stood)) or "no"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("exercise", nargs="*")
    parser.add_argument("--program", default=attempts.PROGRAM)
    parser.add_argument("--out", default="runs/tracked", type=pathlib.Path)
    parser.add_argument("--minutes", type=float, default=1e6, help="begin no other exercise after so many")
    parser.add_argument("--again", type=float, default=100, help="[%%]")
    parser.add_argument("--transport", choices=["vrpn", "vrpn+tcp"], default="vrpn")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="of both, as of rhexis run")
    given = parser.parse_args()
    out = given.out.resolve()
    out.mkdir(parents=True, exist_ok=True)
    attempts.table_head(NAMES)
    rows, lost, begun = [], False, time.monotonic()
    for _, name, recording in exercises(given.exercise):
        if time.monotonic() - begun > 60 * given.minutes:
            break
        recording = {**recording, "set": {**recording.get("set", {}), **dict(one.split("=", 1) for one in given.set)}}
        try:
            before = told(given.program, name, recording, out / "told" / name)
            after, said = came(given.program, name, recording, out / "told" / name, out / "came" / name, given.transport,
                               given.again)
            rows.append(row_of(name, recording, before, after, said))
        except (RuntimeError, SystemExit) as error:
            rows.append([name, f"failed: {error}"] + [""] * (len(NAMES) - 2))
            lost = True
        attempts.table_row(rows[-1])
    with open(out / "table.md", "w", encoding="utf-8") as file:
        for cells in [NAMES, ["---"] * len(NAMES)] + rows:
            file.write("| " + " | ".join(str(cell) for cell in cells) + " |\n")
    sys.exit(1 if lost else 0)


if __name__ == "__main__":
    main()
