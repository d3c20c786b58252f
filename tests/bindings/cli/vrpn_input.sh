#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# rhexis run --input vrpn://: a recording, told by another process as a tracking system would, operates an exercise. By
# the wall clock: parts that take long run beside each other.
set -u
. "$(dirname "$0")/expect.sh"
run=("$rhexis" run navigation --seed 101 --no-pictures)

# serve NAME OPTIONS...: tells what was recorded in $told; $port: where, $server: the process.
told=$work/told
serve() {
    local name=$1
    shift
    "$rhexis" vrpn serve "$told" "$@" >"$work/$name.served" 2>"$work/$name.errors" &
    server=$!
    for _ in $(seq 400); do
        grep -q "^at " "$work/$name.served" && break
        sleep 0.05
    done
    port=$(sed -n 's/^at [0-9.]*:\([0-9]*\): .*/\1/p' "$work/$name.served")
    [ -n "$port" ] || fail "nothing is served: $(cat "$work/$name.errors")"
}
# of RUN FIELD...: a value in its report.
of() { python3 -c 'import json, sys
value = json.load(open(sys.argv[1] + "/report.json"))
for key in sys.argv[2:]: value = value[key]
print(value)' "$@"; }
# told_in NAME TEXT: it was said on standard error by that run.
told_in() { grep -qF -- "$2" "$work/$1.said" || fail "$1 does not say '$2': $(cat "$work/$1.said")"; }
# waits_for NAME TEXT: until it is said; half a minute at most.
waits_for() {
    for _ in $(seq 600); do
        grep -qF -- "$2" "$work/$1.said" && return
        sleep 0.05
    done
    fail "$1 never says '$2': $(cat "$work/$1.said")"
}
# never_leaps NAME: no tip was faster in it than in what was told, but for what is made up for (10 mm/s).
never_leaps() {
    python3 - "$work/told/series.json" "$work/$1/series.json" <<'P' || fail "an instrument leaps in $1"
import json, sys
told, run = (max(v for v in json.load(open(path))["measures"]["probe.speed_mm_s"]["values"] if v is not None)
             for path in sys.argv[1:])
print(f"fastest tip: {told:.1f} mm/s told, {run:.1f} mm/s given", file=sys.stderr)
sys.exit(not run < 1.3 * told + 10)
P
}

expect 0 "" "$rhexis" run navigation --surgeon d --seed 101 --no-pictures --out "$work/told"

# Two at once, one that asks by datagram and one that connects.
serve both --port 0
both=$port
timeout 150 "${run[@]}" --input "vrpn://127.0.0.1:$both" --out "$work/asks" >"$work/asks.out" 2>"$work/asks.said" &
asks=$!
timeout 150 "${run[@]}" --input "vrpn+tcp://127.0.0.1:$both" --out "$work/connects" >"$work/connects.out" 2>"$work/connects.said" &
connects=$!

# On two computers, as far as one can be two: server and client each in a network of its own, with a cable between them.
across_a_cable() {
    local a=rhexis_a_$$ b=rhexis_b_$$ far near
    if ip netns add "$a" 2>"$work/netns" && ip netns add "$b"; then
        ip -n "$a" link add cable type veth peer name cable netns "$b" &&
            ip -n "$a" addr add 10.83.0.1/24 dev cable && ip -n "$b" addr add 10.83.0.2/24 dev cable &&
            ip -n "$a" link set cable up && ip -n "$b" link set cable up
        ip netns exec "$a" "$rhexis" vrpn serve "$work/told" --address 10.83.0.1 >"$work/far" 2>&1 &
        far=$!
        ip netns exec "$b" timeout 100 "${run[@]}" --input vrpn://10.83.0.1 --limit 4 --out "$work/netns_run" >"$work/netns_run.out" 2>"$work/netns_run.said" &
        near=$!
        recorded "$work/netns_run" 40000
        ip -n "$a" link set cable down  # the cable is drawn
        waits_for netns_run "the clock stands: "
        sleep 0.5
        ip -n "$a" link set cable up
        sleep 1
        # what was told meanwhile is elsewhere: told again from the beginning the tip comes by
        kill -9 "$far"
        wait "$far" 2>/dev/null
        ip netns exec "$a" "$rhexis" vrpn serve "$work/told" --address 10.83.0.1 >"$work/far" 2>&1 &
        far=$!
        wait "$near" || fail "the run across a cable failed: $(cat "$work/netns_run.said")"
        kill "$far" 2>/dev/null
        [ "$(of "$work/netns_run" duration_s)" = 4.0 ] || fail "it does not go on to its end"
        never_leaps netns_run
    else
        echo "no network of its own may be made here: $(cat "$work/netns")" >&2
    fi
    ip netns del "$a" 2>/dev/null
    ip netns del "$b" 2>/dev/null
    return "$failures"
}
across_a_cable &
cable=$!

# Meanwhile the server of another is killed and begun again: the clock stands, and goes on when the tip comes by again.
serve first --port 0
timeout 150 "${run[@]}" --input "vrpn://localhost:$port" --limit 5 --out "$work/restart" >"$work/restart.out" 2>"$work/restart.said" &
restart=$!
recorded "$work/restart" 40000
kill -9 "$server"
wait "$server" 2>/dev/null
waits_for restart "the clock stands: the link is lost: "
serve second --port "$port"
waits_for restart "it goes on"
wait "$restart" || fail "the run with a restart failed: $(cat "$work/restart.said")"
kill "$server" 2>/dev/null
told_in restart "rhexis: vrpn://localhost:$port: the clock stands: "
[ "$(of "$work/restart" duration_s)" = 5.0 ] || fail "it does not go on to its end: $(of "$work/restart" duration_s)"
never_leaps restart
expect 0 "" "$rhexis" replay "$work/restart" --verify

# Nobody comes back: it ends, and what was recorded is kept.
serve gone --port 0
timeout 60 "${run[@]}" --input "vrpn://127.0.0.1:$port" --give-up 1 --out "$work/gone" >"$work/gone.out" 2>"$work/gone.said" &
gone=$!
recorded "$work/gone" 20000
kill -9 "$server"
wait "$server" 2>/dev/null
wait "$gone" || fail "a run whose server has gone fails: $(cat "$work/gone.said")"
told_in gone "the clock stood for 1 s: the attempt was ended there"
grep -q "not completed after" "$work/gone.out" || fail "no summary: $(cat "$work/gone.out")"
expect 0 "" "$rhexis" replay "$work/gone" --verify

# What is asked of the staff, and dials that are turned, come with it; what the exercise has not is said in one line.
exercise ask >/dev/null <<'L'
return exercise {
    title = "Asking", patient = { tetrahedra = 500 }, instruments = { "phaco" },
    tissues = { "lens", "bag", "capsule", "iris", "cornea", "chamber" },
    requests = {
        request "Bottle down" { settings = { ["machine.bottle_cm"] = 40 }, meaning = "to 40", answer = "Bottle at 40." },
        request "Help" { meaning = "nothing" },
    },
    steps = { step "low" { done = "requested.bottle_down and chamber.pressure_mmhg < 35" } },
    time_limit_s = 6,
}
L
cat >"$work/ask/surgeon.lua" <<'L'
return function(me)
    me.wait_until(function(seen) return seen and seen.landmarks.incision end, 2)
    local wound = me.see().landmarks.incision.position
    me.take_up({ wound[1], wound[2] - 2, wound[3] + 1 })
    me.pedal(1)
    me.request("Help")
    me.go({ 0, 0, 3 }, 12)
    me.request("Bottle down")
end
L
expect 0 "" "$rhexis" run "$work/ask" --surgeon d --seed 3 --no-pictures --out "$work/asking"
cp -r "$work/ask" "$work/less"
sed -i '/request "Help"/d' "$work/less/curriculum.lua"
told=$work/asking
for which in ask less; do
    serve "$which" --port 0
    timeout 60 "$rhexis" run "$work/$which" --seed 3 --no-pictures --input "vrpn://127.0.0.1:$port" --give-up 2 \
        --out "$work/by_$which" >"$work/by_$which.out" 2>"$work/by_$which.said" || fail "$which: $(cat "$work/by_$which.said")"
    wait "$server"
    [ "$(of "$work/by_$which" completed)" = True ] || fail "$which is not completed by --input: $(cat "$work/by_$which.said")"
done
told=$work/told
! grep -q "no request" "$work/by_ask.said" || fail "what it has was refused: $(cat "$work/by_ask.said")"
told_in by_less "the exercise has no request 'help'"
[ "$(grep -c "no request" "$work/by_less.said")" = 1 ] || fail "it is said more than once: $(cat "$work/by_less.said")"
expect 0 "" "$rhexis" replay "$work/by_ask" --verify

# Nobody there, another version, an address that is none: one line, and nothing is left.
expect 2 "no VRPN server has answered yet" "${run[@]}" --input vrpn://127.0.0.1:9 --wait 0.5 --out "$work/none"
expect 2 "vrpn://ADDRESS" "${run[@]}" --input mouse --out "$work/none"
expect 2 "no VRPN server: 'nowhere'" "${run[@]}" --input vrpn://nowhere --out "$work/none"
expect 2 "--surgeon excludes --input" "${run[@]}" --surgeon d --input vrpn://127.0.0.1 --out "$work/none"
expect 2 "--input is for exercises" "$rhexis" run full_operation --input vrpn://127.0.0.1 --out "$work/none"
echo '{"position_mm": [0, 0], "orientation_xyzw": [0, 0, 0, 1]}' >"$work/frame.json"
expect 2 "position_mm is [0,0] (3 numbers)" "${run[@]}" --input vrpn://127.0.0.1:9 --registration "$work/frame.json" --out "$work/none"
echo '{"position_mm": [0, 0, 0], "orientation_xyzw": [0, 0, 0, 2]}' >"$work/frame.json"
expect 2 "orientation_xyzw has the length 2" "${run[@]}" --input vrpn://127.0.0.1:9 --registration "$work/frame.json" --out "$work/none"
python3 -c 'import socket, time
server = socket.socket(); server.bind(("127.0.0.1", 0)); server.listen(); print(server.getsockname()[1], flush=True)
while True:
    peer, _ = server.accept(); peer.sendall(b"vrpn: ver. 06.38  0\0\0\0\0\0"); time.sleep(0.2); peer.close()' >"$work/old" &
old=$!
for _ in $(seq 200); do [ -s "$work/old" ] && break; sleep 0.05; done
expect 2 "06.38" "${run[@]}" --input "vrpn+tcp://127.0.0.1:$(cat "$work/old")" --wait 1.5 --out "$work/none"
kill "$old"
[ ! -e "$work/none" ] || fail "something is left of a run that never began"

# As well as who was recorded; and what was recorded of it is simulated again bit for bit.
wait "$cable" || fail "what was done across a cable failed"
wait "$asks" || fail "the run that asks failed: $(cat "$work/asks.said")"
wait "$connects" || fail "the run that connects failed: $(cat "$work/connects.said")"
for name in asks connects; do
    grep -q "navigation by person" "$work/$name.out" || fail "$name: $(cat "$work/$name.out")"
    [ "$(of "$work/$name" input)" = vrpn ] || fail "the report does not say with what: $(of "$work/$name" input)"
    [ "$(of "$work/$name" completed)" = True ] || fail "$name is not completed"
    python3 - "$(of "$work/told" osacss scaled)" "$(of "$work/$name" osacss scaled)" \
        "$(of "$work/told" duration_s)" "$(of "$work/$name" duration_s)" <<'P' || fail "$name is not as what was told"
import sys
told, run, told_s, run_s = map(float, sys.argv[1:])
print(f"scaled score {told:.4f} told, {run:.4f} by --input; {told_s:.2f} s told, {run_s:.2f} s", file=sys.stderr)
sys.exit(not (abs(told - run) < 0.05 and abs(told_s - run_s) < 1.5))
P
    never_leaps "$name"
done
expect 0 "" "$rhexis" replay "$work/asks" --verify
finished
