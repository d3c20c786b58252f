#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A virtual surgeon's hands through a rig of cameras, and moved a little: what the report says of it, and what is refused.
set -u
program=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0
wrong() { echo "WRONG: $*"; failed=1; }
cd "$work" || exit 1

"$program" track begin rig --exercise navigation > /dev/null || wrong "begin fails"
sed -i 's/"clip": "tremor"/"clip": "tremor", "level": "markers"/' rig/track.json
operate() { "$program" run navigation --surgeon d --seed 3 --no-pictures --out "$@" 2> err; }
operate early --through rig/track.json > said && wrong "hands go through a rig that is not calibrated"
grep -q "not calibrated" err || wrong "it does not say that the rig is not calibrated: $(cat err)"
[ -e early ] && wrong "a folder is made before it is known whether the rig will do"
"$program" track calibrate rig/track.json > /dev/null || wrong "calibrate fails"

operate bare > said || wrong "bare hands fail"
grep -q "  hands  " said && wrong "bare hands are said to have come through something"
operate through --through rig/track.json > said || wrong "hands through a rig fail: $(cat err)"
grep -q "hands      markers: [0-9]* um off" said || wrong "it does not say how hands came through: $(cat said)"
operate again --through rig/track.json > said
operate moved --moved 1 > said || wrong "moved hands fail: $(cat err)"
python3 - <<'P' || wrong "the reports differ from what hands did"
import json
bare, through, again, moved = (json.load(open(f"{name}/report.json")) for name in ("bare", "through", "again", "moved"))
assert "link" not in bare
link = through["link"]
assert link["name"] == "markers" and link["steps"] > 1000, link
assert 0.0 < link["rms_mm"] < 0.2 and link["rms_mm"] < link["farthest_mm"] < 1.0, link
assert link["unseen"] < 0.02 * link["present"] and link["stood"] < 0.02 * link["steps"], link
assert again["state_hash"] == through["state_hash"] != bare["state_hash"]
assert abs(moved["link"]["rms_mm"] - 1e-3) < 1e-5 and moved["link"]["unseen"] == 0, moved["link"]
assert moved["state_hash"] != bare["state_hash"]
total = lambda report: 100.0 * report["osacss"]["scaled"]
assert abs(total(through) - total(bare)) < 5.0 and abs(total(moved) - total(bare)) < 5.0, (total(bare), total(through), total(moved))
P
"$program" replay through/recording.rhx > /dev/null 2> err || wrong "what came through cannot be done again: $(cat err)"

"$program" run full_operation --through rig/track.json --out whole 2> err && wrong "an operation goes through a rig"
grep -q "through is for exercises" err || wrong "an operation through a rig: $(cat err)"
"$program" run groove --through rig/track.json --out groove 2> err && wrong "a rig without the exercise's instruments does"
grep -q 'no body is called "phaco"' err || wrong "a rig without the exercise's instruments: $(cat err)"
[ -e groove/recording.rhx ] && wrong "an attempt is begun through a rig without its instruments"
[ $failed = 0 ] && echo "all as it should be"
exit $failed
