#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# rhexis vrpn: a recording told over VRPN is heard as it is, both ways to connect; and what is wrong is said in one line.
set -u
. "$(dirname "$0")/expect.sh"
expect 0 "" "$rhexis" run navigation --surgeon d --no-pictures --limit 2 --out "$work/run"

# Tells the recording; $port: where.
serve() {
    "$rhexis" vrpn serve "$work/run" --port 0 --speed 4 >"$work/served" 2>"$work/serve_errors" &
    server=$!
    for _ in $(seq 100); do
        grep -q "^at 127.0.0.1:" "$work/served" && break
        sleep 0.05
    done
    port=$(sed -n 's/^at 127.0.0.1:\([0-9]*\): .*/\1/p' "$work/served")
    [ -n "$port" ] || fail "nothing is served: $(cat "$work/serve_errors")"
}

# By the way that it came: poses by datagram to who asks by datagram, all else, and all to who connects, by TCP.
for way in "" tcp://; do
    by=$([ -n "$way" ] && echo tcp || echo udp)
    serve
    expect 0 "it has closed the connection" "$rhexis" vrpn listen "${way}localhost:$port" probe pedal --json --seconds 3
    wait "$server" || fail "the server ended with an error: $(cat "$work/serve_errors")"
    grep -q "^200 steps told" "$work/served" || fail "not all steps were told: $(cat "$work/served")"
    python3 - "$work/stdout" "$by" <<'P' || fail "what was heard is not what was told ($way)"
import json, sys
lines = [json.loads(line) for line in open(sys.argv[1])]
poses = [l for l in lines if l["kind"] == "pose"]
# 200 steps in half a second, and where they end for another second
assert len(poses) == 600, len(poses)
assert len({tuple(l["position_mm"]) for l in poses[199:]}) == 1
assert {l["by"] for l in poses} == {sys.argv[2]}, {l["by"] for l in poses}
assert {l["by"] for l in lines if l["kind"] != "pose"} == {"tcp"}
assert all(l["device"] == "probe" and l["sensor"] == 0 for l in poses)
assert all(abs(sum(q * q for q in l["quaternion_xyzw"]) - 1) < 1e-9 for l in poses)
assert len({tuple(l["position_mm"]) for l in poses}) > 20, "it does not move"
buttons = [l["down"] for l in lines if l["kind"] == "buttons"]
assert [True] in buttons, buttons[:3]
times = [l["time_s"] for l in poses]
assert times == sorted(times) and 0.3 < times[199] - times[0] < 0.7, times[199] - times[0]
assert any(l["device"] == "pedal" for l in lines)
P
done

# Nobody answers; nothing is where it should be.
expect 1 "no VRPN server has answered yet" "$rhexis" vrpn listen "localhost:$port" probe --seconds 1.6
expect 2 "no VRPN server: 'nowhere' (ADDRESS" "$rhexis" vrpn listen nowhere probe
expect 2 "device is required" "$rhexis" vrpn listen localhost
expect 2 "nowhere.rhx" "$rhexis" vrpn serve "$work/nowhere.rhx"
expect 2 "--from is 7000" "$rhexis" vrpn serve "$work/run" --from 7000
expect 2 "no address: here:3883" "$rhexis" vrpn serve "$work/run" --address here
python3 -c 'import socket, sys, time
s = socket.socket(); s.bind(("127.0.0.1", 0)); s.listen(); print(s.getsockname()[1], flush=True); time.sleep(20)' >"$work/taken" &
taken=$!
for _ in $(seq 200); do [ -s "$work/taken" ] && break; sleep 0.05; done
expect 2 "in use" "$rhexis" vrpn serve "$work/run" --port "$(cat "$work/taken")"
kill "$taken"
finished
