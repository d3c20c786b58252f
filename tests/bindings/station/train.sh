#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# rhexis train as its users meet it: whatever is wrong gives one clear line, and nothing that was done is lost.
set -u
. "$(dirname "$0")/../cli/expect.sh"
small=(--width 160 --height 120 --set patient.tetrahedra=500)

# events NAME: a file of events; its lines after the first are on stdin.
events() {
    { echo "{\"rhexis_events\":1,\"curriculum\":\"groove\",\"seed\":1,\"limit_s\":60,\"set\":{\"patient.tetrahedra\":\"500\"},\"mapping\":$(cat assets/station/mouse.json)}" | tr '\n' ' '
      echo
      cat; } >"$work/$1"
    echo "$work/$1"
}
hash_of() { python3 -c 'import json, sys; print(json.load(open(sys.argv[1] + "/report.json"))["state_hash"])' "$1"; }

# No window.
(unset DISPLAY WAYLAND_DISPLAY
 export SDL_VIDEODRIVER=x11
 expect 2 "no window" "$rhexis" train groove "${small[@]}" --out "$work/none"
 [ "$failures" = 0 ]) || fail "no display"
[ ! -e "$work/none" ] || fail "without a window a folder is left"
(export MESA_GL_VERSION_OVERRIDE=2.1
 export ASAN_OPTIONS=detect_leaks=0  # the driver's own, of a context that it refuses
 expect 2 "OpenGL" "$rhexis" train groove "${small[@]}" --out "$work/none"
 [ "$failures" = 0 ]) || fail "no OpenGL 3.3"

# Names and files.
expect 2 "did you mean 'groove'?" "$rhexis" train grove --out "$work/none"
expect 2 "there is no option --inptu" "$rhexis" train groove --inptu mouse
expect 2 "mouse,gamepad" "$rhexis" train groove --input vrpn
echo '{"key": {"Tab": "swop"}}' >"$work/mapping.json"
expect 2 "there is no control swop" "$rhexis" train groove "${small[@]}" --out "$work/none" --mapping "$work/mapping.json"
expect 2 "nowhere.json" "$rhexis" train groove "${small[@]}" --out "$work/none" --mapping "$work/nowhere.json"
expect 2 "nowhere.jsonl" "$rhexis" train --events "$work/nowhere.jsonl" --again --out "$work/none"
expect 2 "--again requires --events" "$rhexis" train groove --again
echo '{"rhexis_events":7}' >"$work/old.jsonl"
expect 2 "of another version" "$rhexis" train --events "$work/old.jsonl" --again --out "$work/none"
expect 2 "these are events of groove, not of cortex" "$rhexis" train cortex --events "$(events g.jsonl </dev/null)" --again --out "$work/none"
expect 2 "no attempt was cut short" "$rhexis" train --resume "$work"
small_disk=$(df --output=avail,target -B1 2>/dev/null | awk 'NR > 1 && $1 < 1e9 { print $2 }' | while read -r folder; do
    [ -d "$folder" ] && [ -w "$folder" ] && echo "$folder" && break; done)
if [ -n "$small_disk" ]; then
    expect 2 "no room for a recording" "$rhexis" train groove --limit 7200 --out "$small_disk/rhexis_no_room_$$" --width 160
    [ ! -e "$small_disk/rhexis_no_room_$$" ] || fail "without room a folder is left"
fi
[ ! -e "$work/none" ] || fail "a folder is left of an attempt that never began"

# The same events twice, however many pictures are drawn: one state; and it is replayed. The keyboard is lost, the pedal
# is held, the clock stands; a moment is kept and gone back to; a dial is turned.
list=$(events all.jsonl <<'L'
{"step":10,"event":"key","name":"E","value":1}
{"step":10,"event":"key","name":"E","value":0}
{"step":10,"event":"key","name":"2","value":1}
{"step":10,"event":"key","name":"2","value":0}
{"step":20,"event":"wheel","value":-2}
{"step":60,"event":"focus","value":0}
{"step":60,"event":"control","name":"pause","value":1}
{"step":60,"event":"control","name":"meet","value":1}
{"step":80,"event":"control","name":"keep_moment","value":1}
{"step":90,"event":"control","name":"dial.turn","value":3}
{"step":120,"event":"control","name":"try_again","value":1}
{"step":120,"event":"control","name":"meet","value":1}
{"step":150,"event":"quit"}
L
)
expect 0 "" "$rhexis" train --events "$list" --again --out "$work/once" --width 160 --height 120 --picture-every 1
expect 0 "" "$rhexis" train --events "$list" --again --out "$work/twice" --width 200 --height 120 --picture-every 70
[ "$(hash_of "$work/once")" = "$(hash_of "$work/twice")" ] || fail "the same events end in two states"
expect 0 "" "$rhexis" replay "$work/once" --verify --threads 2 --instruction-set baseline
says "all 110 steps"
expect 0 "" "$rhexis" replay "$work/once/left_1.rhx" --verify
says "all 120 steps"
grep -q '"rewound"' "$work/once/report.json" || fail "an attempt that went back does not say so"
grep -q 'With aids' "$work/once/report.html" || fail "nor does its page"
expect 0 "" "$rhexis" replay "$work/once" --score-with groove --json
says '"rewound"'

# An expert's way, on request, and what is no expert's.
list=$(events ghost.jsonl <<'L'
{"step":10,"event":"key","name":"E","value":1}
{"step":10,"event":"control","name":"meet","value":1}
{"step":20,"event":"control","name":"ghost","value":1}
{"step":150,"event":"quit"}
L
)
expect 0 "" "$rhexis" train --events "$list" --again --ghost "$work/once" --out "$work/guided" --width 160 --height 120 --picture-every 50
grep -q '"guided"' "$work/guided/report.json" || fail "an attempt with an expert's way does not say so"
expect 2 "nowhere" "$rhexis" train --events "$list" --again --ghost "$work/nowhere" --out "$work/none" --width 160

# Killed, and gone on with: nothing of the recording is lost, and it is replayed from its start to its end.
limit=(--limit 6)
"$rhexis" train groove "${small[@]}" "${limit[@]}" --out "$work/killed" --by d --live >"$work/stdout" 2>"$work/stderr" &
kill_when_recorded "$work/killed" $!
expect 0 "" "$rhexis" train --resume "$work/killed" --width 160 --height 120 "${limit[@]}" --by d
[ -e "$work/killed/left_1.rhx" ] || fail "what was recorded before is gone"
expect 0 "" "$rhexis" replay "$work/killed" --verify
says "all 300 steps"

# A disk that fills up.
expect 2 "recording.rhx.part: cannot write" bash -c 'limited 1000 "$@"' _ "$rhexis" train groove "${small[@]}" --limit 30 --by d --picture-every 100 --out "$work/full"
expect 0 "cut short" "$rhexis" replay "$work/full" --verify
says "identical"
finished
