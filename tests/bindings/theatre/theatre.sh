#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A station with its monitor and an instructor, as their users meet them: whatever comes or goes, the attempt goes on.
set -u
. "$(dirname "$0")/../cli/expect.sh"
small=(--width 160 --height 120 --set patient.tetrahedra=500)
at="ipc://$work/theatre"
field() { python3 -c 'import json, sys; print(eval("r" + sys.argv[2], {"r": json.load(open(sys.argv[1] + "/report.json"))}))' "$@"; }

# What cannot be asked for, and where nobody is.
expect 2 "is no address" "$rhexis" monitor here
expect 2 "nothing that can be asked for" "$rhexis" monitor "$at" --ask "make it bleed"
expect 2 "no station took it" "$rhexis" monitor "$at" --ask pause
expect 2 "is no address" "$rhexis" train groove "${small[@]}" --theatre nowhere --out "$work/none"
[ ! -e "$work/none" ] || fail "a folder is left of an attempt that never began"
expect 0 "" "$rhexis" monitor "$at" --seconds 0.5 --screenshot "$work/nobody.png"
[ -s "$work/nobody.png" ] || fail "no picture of a monitor without a station"

# An attempt, three monitors, one of them killed and one stopped in the middle, an instructor. The hand is a virtual
# surgeon's, the clock the wall's.
"$rhexis" train surge --by d --seed 101 --live --limit 22 --silent --theatre "$at" --width 160 --height 120 \
    --events "$work/all.jsonl" --out "$work/run" >"$work/train.txt" 2>&1 &
train=$!
"$rhexis" monitor "$at" --json --once >"$work/moments.jsonl" &
lines=$!
"$rhexis" monitor "$at" --seconds 600 --width 480 --height 360 >/dev/null 2>&1 &
killed=$!
"$rhexis" monitor "$at" --json >/dev/null 2>&1 &
stopped=$!
for what in "inject cough" "inject quake" "level impossible" "note well held"; do
    expect 0 "" "$rhexis" monitor "$at" --ask "$what"
done
kill -STOP $stopped
expect 0 "" "$rhexis" monitor "$at" --ask "inject blocked_line"
expect 0 "" "$rhexis" monitor "$at" --ask "put_right blocked_line"
expect 0 "" "$rhexis" monitor "$at" --ask "warn 1"
kill -KILL $killed
expect 0 "" "$rhexis" monitor "$at" --seconds 1 --width 640 --height 480 --screenshot "$work/monitor.png"
wait $train || fail "the attempt ends with $?: $(cat "$work/train.txt")"
wait $lines || fail "the monitor's lines end with $?"
kill -KILL $stopped
wait $stopped 2>/dev/null
[ -s "$work/monitor.png" ] || fail "no picture of the monitor"
[ "$(wc -l <"$work/moments.jsonl")" -gt 20 ] || fail "hardly any moment came"
tail -1 "$work/moments.jsonl" | python3 -c '
import json, sys
last = json.loads(sys.stdin.read())
assert last["ended"] and last["machine"]["there"] and last["score"]["items"], last
assert 30 < last["vitals"]["heart_per_min"] < 200
assert [note["text"] for note in last["notes"]] == ["well held"]' || fail "the last moment is not whole"
grep -q '"text":"well held"' "$work/moments.jsonl" || fail "the note is in no moment"
told=$(field "$work/run" '["aids"]')
case $told in *"The patient coughs"*) ;; *) fail "the cough is in no report: $told" ;; esac
case $told in *"The infusion line is kinked"*) ;; *) fail "the line is in no report: $told" ;; esac
[ "$(field "$work/run" '["notes"][0]["text"]')" = "well held" ] || fail "the note is in no report"
grep -q 'With aids' "$work/run/report.html" || fail "the page does not tell of the instructor"
grep -q 'well held' "$work/run/report.html" || fail "the page does not tell the note"

# All of it is input: done again, and simulated again, it ends in the same state.
expect 0 "" "$rhexis" replay "$work/run" --verify
says "identical"
expect 0 "" "$rhexis" train --events "$work/all.jsonl" --again --out "$work/again" --width 160 --height 120 --picture-every 100
[ "$(field "$work/run" '["state_hash"]')" = "$(field "$work/again" '["state_hash"]')" ] || fail "done again it ends in another state"

# The debriefing: of a whole recording, of one that was cut short, of one without its pictures, of none.
rm -r "$work/run/frames"
expect 0 "" "$rhexis" replay "$work/run" --window --at 10 --seconds 0.5 --width 640 --height 480 --screenshot "$work/debriefing.png"
[ -s "$work/debriefing.png" ] || fail "no picture of the debriefing"
mkdir "$work/cut"
head -c 100000 "$work/run/recording.rhx" >"$work/cut/recording.rhx.part"
expect 0 "" "$rhexis" replay "$work/cut" --window --seconds 0.2 --width 400 --height 300
expect 2 "nowhere" "$rhexis" replay "$work/nowhere" --window --seconds 1
expect 2 "no_such_run" "$rhexis" replay "$work/run" --window --seconds 1 --ghost "$work/no_such_run"
(unset DISPLAY WAYLAND_DISPLAY
 export SDL_VIDEODRIVER=x11
 failures=0
 expect 2 "no window" "$rhexis" replay "$work/run" --window --seconds 1
 expect 2 "no window" "$rhexis" monitor "$at" --seconds 1
 [ "$failures" = 0 ]) || fail "no display"

# Sound through SDL's disk driver: its pitch is where the power of the phaco tip puts it. And none at all.
SDL_AUDIODRIVER=disk SDL_DISKAUDIOFILE=$work/sound.raw "$rhexis" train surge --by d --seed 101 --live --limit 14 \
    --width 160 --height 120 --out "$work/heard" >"$work/heard.txt" 2>&1 || fail "with sound: $(cat "$work/heard.txt")"
python3 "$(dirname "$0")/pitches.py" "$work/sound.raw" "$work/heard/series.json" || fail "the pitch is not that of the power"
(export SDL_AUDIODRIVER=nothing_of_the_kind
 failures=0
 expect 0 "" "$rhexis" train surge --by d --seed 101 --live --limit 2 --width 160 --height 120 --out "$work/deaf"
 [ "$failures" = 0 ]) || fail "without a loudspeaker"
finished
