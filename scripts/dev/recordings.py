#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Expected scores of recordings: curricula/NAME/recordings/*.json.

  scripts/dev/recordings.py NAME...            makes each recording again, replays it, judges it, and compares
  scripts/dev/recordings.py NAME... --update   writes what is expected now (groups d and a, seed 101, where none is)
  scripts/dev/recordings.py --all --longest 30 those whose attempt takes at most 30 s simulated

A file says who operated, with which seed, level and settings, and what came of it. The recording itself is made again: it is
too large to be kept here, and the same inputs give the same bits. Compared are the state hash, the events and their
outcomes, completed exactly (of an operation the hash of each part); the score to 1e-9, both as the run gave it and as
the replay is judged.
Exit status: 0 all agree, 1 some do not, 2 bad usage or bad input.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
TOLERANCE = 1e-9
KNOWN = {"surgeon", "seed", "level", "set", "start", "expected"}
EXPECTED = {"completed", "duration_s", "state_hash", "events", "total", "max", "scaled"}


def fail(text):
    print("recordings: " + text, file=sys.stderr)
    sys.exit(2)


def read(path):
    """A file of expectations, checked."""
    try:
        with open(path, encoding="utf-8") as file:
            given = json.load(file)
    except (OSError, ValueError) as error:
        fail(f"{path}: {error}")
    if not isinstance(given, dict) or set(given) - KNOWN or not {"surgeon", "seed", "expected"} <= set(given):
        fail(f"{path}: holds {sorted(given)}, allowed are {sorted(KNOWN)}, the first three of them needed")
    if set(given["expected"]) != EXPECTED:
        fail(f"{path}: expected holds {sorted(given['expected'])}, needed are {sorted(EXPECTED)}")
    return given


def outcome(result, duration_s, state_hash):
    score = result.get("osacss") or {}
    return {
        "completed": result["completed"],
        "duration_s": duration_s,
        "state_hash": state_hash,
        "events": [[event["id"], event["outcome"]] for event in result["events"]],
        "total": score.get("total"),
        "max": score.get("max"),
        "scaled": score.get("scaled"),
    }


def hash_of(report):
    """Of an operation, one for each part."""
    return [part["state_hash"] for part in report["parts"]] if "parts" in report else report["state_hash"]


def bytes_of(folder):
    """Of the recording, or of those of all parts."""
    files = [os.path.join(path, "recording.rhx") for path, _, names in os.walk(folder) if "recording.rhx" in names]
    return sum(os.path.getsize(file) for file in files)


def run(program, words):
    done = subprocess.run([program] + words, capture_output=True, text=True, cwd=ROOT, check=False)
    return done.returncode, done.stdout, done.stderr.strip()


def make(program, name, given, folder):
    """Runs, replays and judges. The outcome of the run, that of the judged replay, and a complaint or ''."""
    words = ["run", name, "--surgeon", given["surgeon"], "--seed", str(given["seed"]), "--no-pictures", "--json",
             "--out", folder]
    for key, value in given.get("set", {}).items():
        words += ["--set", f"{key}={value}"]
    for option in ("level", "start"):
        if given.get(option):
            words += ["--" + option, given[option]]
    status, text, said = run(program, words)
    if status != 0:
        return None, None, said
    report = json.loads(text)
    first = outcome(report, report["duration_s"], hash_of(report))
    status, text, said = run(program, ["replay", folder, "--verify", "--score-with", name, "--json"])
    if status != 0:
        return first, None, "the replay differs: " + (said or json.loads(text).get("verdict", ""))
    judged = json.loads(text)
    if judged.get("simulated_from_step"):
        return first, None, "judging simulates again: " + said
    return first, outcome(judged["result"], report["duration_s"], first["state_hash"]), ""


def differences(expected, found, what):
    lines = []
    for key in sorted(EXPECTED):
        a, b = expected[key], found[key]
        numbers = all(isinstance(x, (int, float)) and not isinstance(x, bool) for x in (a, b))
        if not (abs(a - b) <= TOLERANCE if numbers else a == b):
            lines.append(f"{what}: {key} is {b}, expected {a}")
    return lines


def files_of(name):
    folder = os.path.join(ROOT, "curricula", name, "recordings")
    found = sorted(os.listdir(folder)) if os.path.isdir(folder) else []
    return [os.path.join(folder, file) for file in found if file.endswith(".json")]


def check(program, name, path, update):
    given = read(path) if os.path.exists(path) else {"surgeon": os.path.basename(path)[0], "seed": 101}
    with tempfile.TemporaryDirectory() as folder:
        first, judged, complaint = make(program, name, given, os.path.join(folder, "run"))
        size = bytes_of(folder) if first else 0
    lines = [complaint] if complaint else []
    if not complaint and update:
        lines = differences(first, judged, "judged again")
        given["expected"] = first
        if not lines:
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path + ".part", "w", encoding="utf-8") as file:
                json.dump(given, file, indent=2)
                file.write("\n")
            os.replace(path + ".part", path)
    elif not complaint:
        lines = differences(given["expected"], first, "made again") + differences(given["expected"], judged,
                                                                                  "judged again")
    label = os.path.relpath(path, ROOT)
    if first:
        print(f"{'FAIL' if lines else 'ok  '}  {label}: {first['duration_s']:.1f} s, scaled {first['scaled']}, "
              f"{len(first['events'])} events, recording {size / 1e6:.1f} MB")
    else:
        print(f"FAIL  {label}")
    for line in lines:
        print("        " + line)
    sys.stdout.flush()
    return not lines


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("names", nargs="*", metavar="NAME", help="exercises in curricula/")
    options.add_argument("--all", action="store_true", help="all that have expected scores")
    options.add_argument("--update", action="store_true", help="write what comes of it now")
    options.add_argument("--longest", type=float, default=1e9, metavar="S",
                         help="leave out attempts that are expected to take longer, simulated")
    options.add_argument("--program", default=os.path.join(ROOT, "build/release/bindings/cli/rhexis"))
    given = options.parse_args()
    folder = os.path.join(ROOT, "curricula")
    known = sorted(name for name in os.listdir(folder) if os.path.exists(os.path.join(folder, name, "curriculum.lua")))
    names = [name for name in known if files_of(name)] if given.all else given.names
    if not names:
        fail("no exercise is named")
    work = []
    for name in names:
        if name not in known:
            fail(f"there is no exercise {name} in curricula/; there are {', '.join(known)}")
        paths = files_of(name)
        if given.update and not paths:
            paths = [os.path.join(folder, name, "recordings", f"{group}101.json") for group in "da"]
        if not paths:
            fail(f"{name} has no recordings/*.json; --update writes them")
        for path in paths:
            longest = read(path)["expected"]["duration_s"] if os.path.exists(path) else 0
            if longest <= given.longest:
                work.append((name, path))
    if not work:
        fail("none is as short as that")
    good = [check(given.program, name, path, given.update) for name, path in work]
    print(f"{sum(good)} agree, {len(good) - sum(good)} differ")
    sys.exit(0 if all(good) else 1)


if __name__ == "__main__":
    main()
