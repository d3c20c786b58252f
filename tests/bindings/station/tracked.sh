#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# rhexis train --input vrpn://: in the window, by instruments that a tracking system sees.
set -u
. "$(dirname "$0")/../cli/expect.sh"
small=(--width 160 --height 120 --no-open --silent)

# serve: tells what was recorded, at $port if there is one; $server: the process.
serve() {
    "$rhexis" vrpn serve "$work/told" --port "${port:-0}" >"$work/served" 2>"$work/serve_errors" &
    server=$!
    for _ in $(seq 400); do
        grep -q "^at " "$work/served" && break
        sleep 0.05
    done
    port=$(sed -n 's/^at [0-9.]*:\([0-9]*\): .*/\1/p' "$work/served")
    [ -n "$port" ] || fail "nothing is served: $(cat "$work/serve_errors")"
}
hash_of() { python3 -c 'import json, sys; print(json.load(open(sys.argv[1] + "/report.json"))["state_hash"])' "$1"; }

expect 2 "mouse,gamepad" "$rhexis" train navigation --input vrpn
expect 2 "no VRPN server: 'nowhere'" "$rhexis" train navigation --input vrpn://nowhere
expect 2 "--by works a mouse or a gamepad" "$rhexis" train navigation --input vrpn://127.0.0.1 --by d
expect 2 "nowhere.json" "$rhexis" train navigation --input vrpn://127.0.0.1 --registration "$work/nowhere.json" "${small[@]}" --out "$work/none"
[ ! -e "$work/none" ] || fail "a folder is left of an attempt that never began"

# The server goes and comes again: the clock stands, and goes on when the tip comes by.
expect 0 "" "$rhexis" run navigation --surgeon d --seed 101 --no-pictures --limit 6 --out "$work/told"
serve
timeout 120 "$rhexis" train navigation --seed 101 --input "vrpn://127.0.0.1:$port" --limit 4 "${small[@]}" --out "$work/live" \
    --events "$work/events.jsonl" >"$work/live.out" 2>"$work/live.said" &
live=$!
recorded "$work/live" 40000
kill -9 "$server"
wait "$server" 2>/dev/null
sleep 1
serve
wait "$live" || fail "the attempt failed: $(cat "$work/live.said")"
kill "$server" 2>/dev/null
[ ! -s "$work/live.said" ] || fail "not silent: $(cat "$work/live.said")"
grep -q "navigation by person, seed 101: not completed after 4.0 s" "$work/live.out" || fail "$(cat "$work/live.out")"
python3 - "$work/events.jsonl" <<'P' || fail "the clock did not stand for the lost link and go on"
import json, sys
lines = [json.loads(line) for line in open(sys.argv[1])][1:]
told = [(l["value"], l.get("name", "")) for l in lines if l["event"] == "tracking"]
lost = next(i for i, (runs, why) in enumerate(told) if not runs and why == "the link is lost: %s")
sys.exit(not ((1, "") in told[:lost] and (1, "") in told[lost:]))
P

# What was recorded is simulated again, and what was told done again, bit for bit.
expect 0 "" "$rhexis" replay "$work/live" --verify
expect 0 "" "$rhexis" train --events "$work/events.jsonl" --again "${small[@]}" --out "$work/again"
[ "$(hash_of "$work/live")" = "$(hash_of "$work/again")" ] || fail "done again it ends in another state"
finished
