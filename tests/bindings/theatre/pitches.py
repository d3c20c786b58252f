#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""pitches.py SOUND SERIES: whether a recorded sound (floats, 44100 Hz, one channel) has the pitches of an attempt.

The highest pitch of the vacuum's voice must lie between those of the highest vacuum that lasted under an aspirating foot
and of the highest of all (on a machine that falls behind, a short one sounds long), and the pitch of the strongest
sound of ultrasound must be that of a power which the attempt had. Exit status 1 if not.
"""
import array
import json
import math
import sys

KEPT = 4  # every fourth sample is enough up to 1 kHz
RATE = 44100 // KEPT
WINDOW = 4410
NEAR = 45  # a busy machine plays with gaps, and a window that ends in one, or glides, is heard beside its pitch [Hz]
VACUUM = range(500, 1001, 5)
ULTRASOUND = range(220, 441, 5)


def power_at(samples, hz):
    """Goertzel's sum."""
    turn = 2 * math.cos(2 * math.pi * hz / RATE)
    a = b = 0.0
    for sample in samples:
        a, b = sample + turn * a - b, a
    return (a * a + b * b - turn * a * b) * 4 / len(samples) ** 2


def strongest(samples, pitches):
    return max((power_at(samples, hz), hz) for hz in pitches)


def main():
    with open(sys.argv[1], "rb") as file:
        sound = array.array("f", file.read())
    with open(sys.argv[2], encoding="utf-8") as file:
        measures = json.load(file)["measures"]
    values = {name: measures[name]["values"] for name in ("phaco.pedal", "phaco.power", "panel.vacuum_mmhg")}
    vacuums = sorted(v for v, pedal in zip(values["panel.vacuum_mmhg"], values["phaco.pedal"]) if pedal and pedal >= 2)
    powers = [p for p in values["phaco.power"] if p and p > 0.02]  # of pulses, the mean over a step
    heard = []
    for at in range(0, len(sound) - WINDOW, 2 * WINDOW):
        window = sound[at:at + WINDOW:KEPT]
        if max(abs(s) for s in window) > 0.02:
            heard.append(window)
    highest = max((hz for power, hz in (strongest(w, VACUUM) for w in heard) if power > 1e-3), default=0)
    lasted, most = (500 + 500 * vacuum / 650 for vacuum in (vacuums[-20], vacuums[-1]))
    print(f"vacuum {vacuums[-20]:.0f} to {vacuums[-1]:.0f} mmHg: {lasted:.0f} to {most:.0f} Hz, heard {highest} Hz")
    loudest, pitch = max(strongest(w, ULTRASOUND) for w in heard)
    low, high = 220 + 220 * min(powers), 220 + 220 * max(powers)
    print(f"power {min(powers):.2f} to {max(powers):.2f}: {low:.0f} to {high:.0f} Hz, heard {pitch} Hz ({loudest:.1e})")
    loud = loudest > 1e-3 and low - NEAR <= pitch <= high + NEAR
    return 0 if loud and lasted - NEAR <= highest <= most + NEAR else 1


if __name__ == "__main__":
    sys.exit(main())
