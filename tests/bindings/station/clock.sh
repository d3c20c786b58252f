#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# rhexis train by the wall clock, where the machine or the display goes away: nothing is caught up, nothing is lost. No
# time is asserted.
set -u
. "$(dirname "$0")/../cli/expect.sh"
small=(--width 160 --height 120 --no-open --set patient.tetrahedra=500)

# in_events TEXT: waits until a line of the events that are being kept has it.
in_events() {
    for _ in $(seq 200); do
        grep -qs -- "$1" "$work"/events.jsonl.*.unfinished && return
        sleep 0.1
    done
    fail "no event with $1: $(tail -n 2 "$work"/events.jsonl.*.unfinished)"
}

# Suspended: the clock stands when it wakes, and the time that it slept is no step of the recording.
"$rhexis" train groove "${small[@]}" --events "$work/events.jsonl" --out "$work/asleep" >/dev/null 2>"$work/stderr" &
person=$!
recorded "$work/asleep" 0
sleep 2
kill -STOP "$person"
sleep 4
kill -CONT "$person"
in_events '"name":"away"'
sleep 1
kill -9 "$person"
wait 2>/dev/null
away=$(grep '"name":"away"' "$work"/events.jsonl.*.unfinished | head -1 | sed 's/.*"step":\([0-9]*\).*/\1/')
expect 0 "cut short" "$rhexis" replay "$work/asleep" --verify
steps=$(sed -n 's/.*all \([0-9]*\) steps.*/\1/p' "$work/stdout")
[ -n "$steps" ] && [ "$steps" -le "$((away + 1))" ] || fail "the clock went on after it woke at step $away: $steps steps"

# The X server is gone: one line says how to go on, and so it is gone on with.
mkfifo "$work/display"
Xvfb -displayfd 3 -screen 0 320x240x24 3>"$work/display" >/dev/null 2>&1 &
server=$!
read -r number <"$work/display"
(unset SDL_VIDEODRIVER
 DISPLAY=:$number exec "$rhexis" train groove "${small[@]}" --by d --live --limit 60 --out "$work/gone" >/dev/null 2>"$work/stderr") &
person=$!
recorded "$work/gone" 50000
kill "$server"
wait "$person"
got=$?
[ "$got" = 2 ] || fail "without its X server: status $got"
grep -q "rhexis train --resume $work/gone" "$work/stderr" || fail "nothing says how to go on: $(head -c 300 "$work/stderr")"
expect 0 "" "$rhexis" train --resume "$work/gone" --by d --limit 6 --width 160 --height 120
expect 0 "" "$rhexis" replay "$work/gone" --verify
says "all 300 steps"
finished
