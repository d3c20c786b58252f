#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The scripted person: a virtual surgeon works mouse, keys, pad and pedal of `rhexis train`.

  scripts/dev/station.py cortex --input gamepad      its total beside that of the same surgeon without the window
  scripts/dev/station.py --all --group a             all 22 exercises
  scripts/dev/station.py capsulorhexis --again       besides, its events done again: the same state in the end
  scripts/dev/station.py surge --twins 5             the same seed, five hands that differ by less than a pixel
  scripts/dev/station.py --all --live 120            by the wall clock, so many simulated seconds each: how they keep up

Totals are of 100. Without --live each must be within 5 of the same seed without the window, which is taken from
curricula/NAME/recordings where it is known and the input hides no item of it. Nothing is drawn on a screen (SDL_VIDEODRIVER=offscreen unless it is set).
Exit status: 0 all do, 1 some do not, 2 bad usage or bad input.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
MAY_DIFFER = 5.0  # of 100


def fail(text):
    print("station: " + text, file=sys.stderr)
    sys.exit(2)


def exercises():
    folder = os.path.join(ROOT, "curricula")
    return sorted(name for name in os.listdir(folder)
                  if os.path.exists(os.path.join(folder, name, "surgeon.lua")))


def run(given, words):
    done = subprocess.run([given.program] + words, capture_output=True, text=True, cwd=ROOT, check=False,
                          env={"SDL_VIDEODRIVER": "offscreen", **os.environ})
    return done.returncode, done.stdout, done.stderr.strip()


def report_of(folder):
    with open(os.path.join(folder, "report.json"), encoding="utf-8") as file:
        return json.load(file)


def of_100(total, most):
    return 100.0 * total / most


def known_without_window(given, name):
    """Total, of 100, and simulated seconds, of curricula/NAME/recordings; or None."""
    known = os.path.join(ROOT, "curricula", name, "recordings", f"{given.group}{given.seed}.json")
    if not os.path.exists(known):
        return None
    with open(known, encoding="utf-8") as file:
        one = json.load(file)
    if set(one) != {"surgeon", "seed", "expected"}:
        return None
    return of_100(one["expected"]["total"], one["expected"]["max"]), one["expected"]["duration_s"]


def without_window(given, name, folder):
    """The same, judged as what is done with this input is."""
    status, _, said = run(given, ["run", name, "--surgeon", given.group, "--seed", str(given.seed), "--no-pictures",
                                  "--set", "input=" + given.input, "--out", folder])
    if status == 2:
        fail(said)
    report = report_of(folder)
    return of_100(report["osacss"]["total"], report["osacss"]["max"]), report["duration_s"]


def expected_of(given, name, report, folder):
    """Total, of 100, and simulated seconds without the window, as a report is judged that was made with it."""
    hides_items = any(item.get("hidden") and item.get("score") is None for item in report["osacss"]["items"])
    known = None if hides_items else known_without_window(given, name)
    return known or without_window(given, name, folder)


def train(given, name, folder, more):
    return run(given, ["train", name, "--seed", str(given.seed), "--input", given.input, "--width", "640", "--height",
                       "480", "--out", folder] + more)


def done_again(given, name, folder, events, report):
    """What is wrong when the events are done again; or nothing."""
    again = os.path.join(folder, "again")
    status, _, said = run(given, ["train", "--events", events, "--again", "--picture-every", "200", "--out", again,
                                  "--width", "320", "--height", "240"])
    if status == 2:
        return said
    if report_of(again)["state_hash"] != report["state_hash"]:
        return "done again, the events end in another state"
    status, text, said = run(given, ["replay", os.path.join(folder, "train"), "--verify", "--json", "--threads", "2",
                                     "--instruction-set", "baseline"])
    return "" if status == 0 else "replayed with two threads and without wide instructions: " + (said or text)


def controls_used(events):
    """Names of the controls that were worked, in the order of the first use."""
    with open(events, encoding="utf-8") as file:
        mapping = json.loads(next(file))["mapping"]
        used = {}
        for line in file:
            event = json.loads(line)
            kind, name = event["event"], event.get("name", "")
            device, _, inner = name.partition(".")
            worked = (mapping["key"].get(name) if kind == "key" else mapping["mouse"].get(name) if kind == "button" else
                      mapping["mouse"].get("move") if kind == "pointer" else mapping["mouse"].get("wheel")
                      if kind == "wheel" else mapping.get(device, {}).get(inner) if kind in ("axis", "press") else name
                      if kind == "control" else None)
            if worked and (kind == "pointer" or kind == "wheel" or event.get("value")):
                used[worked.lstrip("-")] = True
    return list(used)


def compare(given, name):
    with tempfile.TemporaryDirectory() as folder:
        events = os.path.join(folder, "events.jsonl")
        status, _, said = train(given, name, os.path.join(folder, "train"),
                                ["--by", given.group, "--picture-every", "1000", "--events", events])
        if status == 2:
            fail(said)
        report = report_of(os.path.join(folder, "train"))
        total = of_100(report["osacss"]["total"], report["osacss"]["max"])
        expected, seconds = expected_of(given, name, report, os.path.join(folder, "run"))
        wrong = "" if abs(total - expected) <= MAY_DIFFER else f"more than {MAY_DIFFER:g} apart"
        if given.again and not wrong:
            wrong = done_again(given, name, folder, events, report)
        with open(events, encoding="utf-8") as file:
            count = sum(1 for _ in file) - 1
        used = controls_used(events)
    print(f"{'FAIL' if wrong else 'ok  '}  {name:26} {total:6.1f} with {given.input}, {expected:6.1f} without; "
          f"{report['duration_s']:.0f} and {seconds:.0f} s, {'' if report['completed'] else 'not '}completed, "
          f"{count} events{'; ' + wrong if wrong else ''}", flush=True)
    if given.controls:
        print(f"      {', '.join(used)}", flush=True)
    return not wrong


def twins(given, name):
    """Totals of the same seed with a hand that follows a hair otherwise: in windows of other widths, whose pixels lie
    elsewhere. How far apart they are is how far apart nobody can tell from chance."""
    totals = []
    for i in range(given.twins):
        with tempfile.TemporaryDirectory() as folder:
            status, _, said = run(given, ["train", name, "--seed", str(given.seed), "--input", given.input, "--width",
                                          "640", "--height", str(480 + 7 * i), "--by", given.group, "--picture-every",
                                          "1000", "--out", os.path.join(folder, "train")])
            if status == 2:
                fail(said)
            report = report_of(os.path.join(folder, "train"))
            totals.append(of_100(report["osacss"]["total"], report["osacss"]["max"]))
    with tempfile.TemporaryDirectory() as folder:
        expected, _ = expected_of(given, name, report, os.path.join(folder, "run"))
    inside = min(totals) - MAY_DIFFER <= expected <= max(totals) + MAY_DIFFER
    print(f"{'ok  ' if inside else 'FAIL'}  {name:26} {' '.join(f'{total:.1f}' for total in totals)} with {given.input}, "
          f"{expected:.1f} without; seed {given.seed}", flush=True)
    return inside


def live(given, name):
    with tempfile.TemporaryDirectory() as folder:
        status, _, said = train(given, name, os.path.join(folder, "train"),
                                ["--by", given.group, "--live", "--limit", str(given.live)])
        if status == 2:
            fail(said)
        report = report_of(os.path.join(folder, "train"))
    p, pace = report["performance"], report["performance"]["live"]
    print(f"| {name} | {report['duration_s']:.0f} | {p['cpu_s_per_s']:.2f} | {p['mean_step_ms']:.1f} | "
          f"{p['p99_step_ms']:.1f} | {p['worst_step_ms']:.0f} | {pace['late_p99_9_steps']:.2f} | "
          f"{100 * pace['slowed_share']:.1f} | {pace['pictures_per_s']:.0f} | {p['checkpoints']['worst_taking_ms']:.1f} + "
          f"{p['checkpoints']['worst_writing_ms']:.0f} | {pace['steal_s']} |", flush=True)
    return True


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME[:SEED]")
    parser.add_argument("--all", action="store_true", help="all exercises that have a virtual surgeon")
    parser.add_argument("--input", choices=["mouse", "gamepad"], default="mouse")
    parser.add_argument("--group", choices=list("abcd"), default="d")
    parser.add_argument("--seed", type=int, default=101)
    parser.add_argument("--again", action="store_true", help="do the events again as well, and replay the recording")
    parser.add_argument("--controls", action="store_true", help="say which were worked")
    parser.add_argument("--twins", type=int, metavar="N", help="N hands that follow a hair otherwise")
    parser.add_argument("--live", type=float, metavar="SECONDS", help="by the wall clock")
    parser.add_argument("--program", default=os.path.join(ROOT, "build/release/bindings/cli/rhexis"))
    given = parser.parse_args()
    names = []
    for name in exercises() if given.all else given.names:
        name, _, seed = name.partition(":")
        if name not in exercises():
            fail(f"there is no exercise {name} with a virtual surgeon")
        if seed and not seed.isdecimal():
            fail(f"the seed {seed} is no whole number")
        names.append((name, int(seed) if seed else given.seed))
    if not names:
        fail("which exercise? NAME ..., or --all")
    given.program = os.path.abspath(given.program)
    if given.live:
        print("| exercise | simulated s | CPU s per s | mean step ms | p99 | worst | late p99.9, steps | slowed % | "
              "pictures/s | checkpoint ms, here + there | left out s |\n" + "|---" * 11 + "|")
    do = live if given.live else twins if given.twins else compare
    done = []
    for name, given.seed in names:
        done.append(do(given, name))
    return 0 if all(done) else 1


if __name__ == "__main__":
    sys.exit(main())
