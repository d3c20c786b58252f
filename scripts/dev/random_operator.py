#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Ten minutes of a random operator in every exercise and in three patients; prints a table.

usage: scripts/dev/random_operator.py [--seconds 600] [--seed 11] [--tetrahedra 1000] [--replay] [--only EXERCISE] [--jobs 2]
       [--rhexis PROGRAM] [--station]

--station: a random person at the devices of rhexis train instead: keys, buttons, cursor, wheel, a keyboard and pads that
are lost, moments gone back to, keys that change their use.

For each: attempts that it took (one that ends early is followed by another with the next seed), errors raised, steps that
had to be redone, what part of the lens's volume is not accounted for at most, CPU seconds per simulated second, and with
--replay whether a second simulation gives the same state hash in every step.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile

import attempts

SHORTEST = 1.0  # attempt that an exercise takes [s]
DENSITY = 1.05  # of the lens [mg/mm^3]
RUNS = [
    ("phaco_sculpt", None),
    ("phaco_quadrants", None),
    ("phaco_crack", None),
    ("phaco_sculpt", "white"),
    ("phaco_quadrants", "soft"),
    ("groove", None),
    ("phaco_sculpt", "brunescent"),
    ("capsulorhexis", None),
    ("capsulorhexis_rescue", None),
    ("iol_injection", None),
    ("wound_burn", None),
    ("iris_prolapse", None),
    ("incision", None),
    ("wound_closure", None),
    ("hydrodissection", None),
    ("cortex", None),
    ("zonular_weakness", None),
    ("viscoelastic_removal", None),
    ("set_up", None),
    ("forceps_skill", None),
    ("navigation", None),
    ("overfilled_chamber", None),
    ("surge", None),
    ("dropped_fragment", None),
    ("posterior_capsule_rupture", None),
]


def volume(series, index):
    """Of the whole lens: what went and what is left, crumbs included [mm^3]."""
    left = series.get("fragments.left_mm3")
    return None if left is None else series["lens.removed_mg"][index] / DENSITY + left[index]


def volume_lost(series):
    """What is not accounted for at the end, of the volume at the start; None for an exercise without a lens."""
    first, last = volume(series, 0), volume(series, -1)
    return None if first is None else abs(last - first) / first


def options_of(patient, seconds, tetrahedra):
    """Further options of rhexis run."""
    more = ["--limit", str(seconds), "--set", f"time_limit_s={seconds}"]
    if tetrahedra:
        more += ["--set", f"patient.tetrahedra={tetrahedra}"]
    if patient:
        more += ["--patient", str(attempts.ROOT / "assets" / "patients" / f"{patient}.json")]
    return more


def replays(program, folder):
    """Whether a second simulation ends every step in the same state."""
    command = [program, "replay", str(folder / "recording.rhx"), "--verify"]
    return subprocess.run(command, cwd=attempts.ROOT, stdout=subprocess.DEVNULL).returncode == 0


CHANGES_HANDS = {"next_instrument", "put_down", "swap"}  # seldom, or nothing comes into the eye
# What would end the attempt, or stop its clock for good: those are pressed on purpose below.
NOT_AT_RANDOM = {"stop", "pause", "try_again", "keep_moment", "tip"}


def random_events(chance, mapping, steps):
    """What a person does who presses whatever there is, step by step."""
    keys = [(device, name) for device in ("key", "mouse", "pad", "pedal") for name, control in mapping[device].items()
            if control.lstrip("-") not in NOT_AT_RANDOM and name not in ("move", "wheel")]
    x = y = 0.0
    step = 0
    while step < steps:
        step += chance.randint(1, 8)

        def event(kind, **fields):
            return {"step": step, "event": kind, **fields}

        what = chance.random()
        if what < 0.5:
            x += chance.gauss(0.0, 0.02)
            y += chance.gauss(0.004 if step % 6000 < 3000 else -0.004, 0.02)  # in through the wound, and out again
            yield event("pointer", x=x, y=y)
        elif what < 0.6:
            yield event("wheel", value=chance.choice([-3, -1, 1, 3]))
        elif what < 0.95:
            device, name = chance.choice(keys)
            if mapping[device][name] in CHANGES_HANDS and chance.random() < 0.8:
                continue
            value = chance.choice([0, 1])
            if device == "key":
                yield event("key", name=name, value=value)
            elif device == "mouse":
                yield event("button", name=name, value=value)
            elif name in ("leftx", "lefty", "rightx", "righty", "lefttrigger", "righttrigger", "0"):
                yield event("axis", name=f"{device}.{name}", value=chance.uniform(-1, 1))
            else:
                yield event("press", name=f"{device}.{name}", value=value)
        elif what < 0.97:
            yield chance.choice([event("focus", value=0), event("focus", value=0, name="away"),
                                 event("device", name="pad", value=0), event("device", name="pedal", value=0)])
            yield event("control", name="pause", value=1)
        elif what < 0.98:
            yield event("bind", name="key." + chance.choice("EQWASD"),
                        control=chance.choice(["", "squeeze", "swap", "-hand.z", "next_instrument", "nothing"]))
        elif what < 0.99:
            yield event("control", name=chance.choice(["take_instrument", "choose_dial", "choose_request"]),
                        value=chance.randint(-1, 9))
        else:
            yield event("control", name="keep_moment", value=1)
        yield event("control", name="meet", value=1)


def attempt_by_person(program, exercise, seed, folder, more, seconds):
    """As attempts.attempt, by a random person at the devices."""
    folder.mkdir(parents=True)
    with open(attempts.ROOT / "assets" / "station" / "mouse.json", encoding="utf-8") as file:
        mapping = json.load(file)
    settings = dict(pair.split("=", 1) for option, pair in zip(more, more[1:]) if option == "--set")
    header = {"rhexis_events": 1, "curriculum": exercise, "seed": seed, "limit_s": seconds, "set": settings,
              "mapping": mapping}
    with open(folder / "events.jsonl", "w", encoding="utf-8") as file:
        for line in [header, *random_events(random.Random(seed), mapping, int(seconds * 100))]:
            file.write(json.dumps(line) + "\n")
    patient = [word for option, path in zip(more, more[1:]) if option == "--patient" for word in (option, path)]
    command = [program, "train", "--events", str(folder / "events.jsonl"), "--again", "--width", "160", "--height", "120",
               "--picture-every", "2000", "--out", str(folder)] + patient
    done = subprocess.run(command, cwd=attempts.ROOT, capture_output=True, text=True,
                          env={"SDL_VIDEODRIVER": "offscreen", **os.environ})
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(command)}: {done.stderr.strip()}")
    return json.loads((folder / "report.json").read_text())


def all_attempts(options, exercise, patient, folder):
    """Attempts until they make up the time: of each its report, the volume lost, and whether it replays."""
    found, left = [], options.seconds
    while left > 0:
        here = folder / str(len(found))
        more = options_of(patient, max(left, SHORTEST), options.tetrahedra)
        seed = options.seed + len(found)
        report = (attempt_by_person(options.rhexis, exercise, seed, here, more, max(left, SHORTEST)) if options.station
                  else attempts.attempt(options.rhexis, exercise, "random", seed, here, more))
        same = replays(options.rhexis, here) if options.replay else None
        found.append((report, volume_lost(attempts.series(here)), same))
        left -= report["duration_s"]
    return found


def one(options, exercise, patient, folder):
    found = all_attempts(options, exercise, patient, folder)
    reports = [report for report, _, _ in found]
    lost = [share for _, share, _ in found if share is not None]
    seconds = sum(report["duration_s"] for report in reports)
    redone, steps = (sum(report["performance"][name] for report in reports) for name in ("rollbacks", "steps"))
    cpu = sum(report["performance"]["cpu_s_per_s"] * report["duration_s"] for report in reports)
    return [exercise, patient or "its own", f"{seconds:.0f} s", len(found), sum(len(r["events"]) for r in reports),
            f"{redone} of {steps}", f"{100 * max(lost):.3f} %" if lost else "-", f"{cpu / seconds:.2f}",
            ("yes" if all(same for _, _, same in found) else "NO") if options.replay else "-"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=600)
    parser.add_argument("--seed", type=int, default=11, help="of the first attempt")
    parser.add_argument("--tetrahedra", type=int, default=1000, help="0: as the exercise says")
    parser.add_argument("--replay", action="store_true", help="simulate again and compare every step")
    parser.add_argument("--rhexis", default=attempts.PROGRAM)
    parser.add_argument("--only", help="an exercise")
    parser.add_argument("--station", action="store_true", help="a random person at the devices of rhexis train")
    parser.add_argument("--jobs", type=int, default=1)
    options = parser.parse_args()
    attempts.table_head(["exercise", "patient", "simulated", "attempts", "errors", "steps redone", "volume lost", "CPU s per s",
                         "same hash"])
    runs = [run for run in RUNS if options.only in (None, run[0])]

    def row_of(run):
        with tempfile.TemporaryDirectory() as folder:
            return one(options, *run, pathlib.Path(folder) / "run")

    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for row in pool.map(row_of, runs):
            attempts.table_row(row)


if __name__ == "__main__":
    sys.exit(main())
