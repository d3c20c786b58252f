#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# rhexis igtl against the example programs of OpenIGTLink's own package, both ways: what they tell is heard, what is
# told is heard by them. Where the examples are not installed, ours is heard by ours only.
set -u
. "$(dirname "$0")/expect.sh"
examples=/usr/share/doc/openigtlink-examples/examples
ours=()
trap 'kill "${ours[@]}" 2>/dev/null; rm -rf "$work"' EXIT
expect 0 "" "$rhexis" run navigation --surgeon d --no-pictures --limit 2 --out "$work/run"

# Tells the recording; $port: where.
serve() {
    "$rhexis" igtl serve "$work/run" --port 0 --speed "$1" >"$work/served" 2>"$work/serve_errors" &
    server=$!
    ours+=("$server")
    for _ in $(seq 100); do
        grep -q "^at 127.0.0.1:" "$work/served" && break
        sleep 0.05
    done
    port=$(sed -n 's/^at 127.0.0.1:\([0-9]*\): .*/\1/p' "$work/served")
    [ -n "$port" ] || fail "nothing is served: $(cat "$work/serve_errors")"
}
served() {
    wait "$server" || fail "the server ended with an error: $(cat "$work/serve_errors")"
    grep -q "^200 steps told" "$work/served" || fail "not all steps were told: $(cat "$work/served")"
}

serve 4
expect 0 "it has closed the connection" "$rhexis" igtl listen "localhost:$port" --json --seconds 3
served
cp "$work/stdout" "$work/by_ours"
python3 - "$work/by_ours" <<'P' || fail "what was heard is not what was told"
import json, sys
lines = [json.loads(line) for line in open(sys.argv[1])]
poses = [l for l in lines if l["kind"] == "pose"]
assert 550 < len(poses) <= 600, len(poses)  # of half a second, and where they end for another second
assert all(l["device"] == "probe" and l["sensor"] == 0 for l in poses)
assert all(abs(sum(q * q for q in l["quaternion_xyzw"]) - 1) < 1e-9 for l in poses)
assert len({tuple(l["position_mm"]) for l in poses}) > 20, "it does not move"
assert any(l["kind"] == "text" and l["text"] == "probe" for l in lines), "no status names the probe"
times = [l["time_s"] for l in poses]
assert times == sorted(times)
P

expect 1 "nobody answers" "$rhexis" igtl listen "localhost:$port" --seconds 1.2
expect 2 "no OpenIGTLink server: 'nowhere' (ADDRESS" "$rhexis" igtl listen nowhere
expect 2 "server is required" "$rhexis" igtl listen
expect 2 "nowhere.rhx" "$rhexis" igtl serve "$work/nowhere.rhx"
expect 2 "no address: here:18944" "$rhexis" igtl serve "$work/run" --address here

if [ ! -d "$examples" ]; then
    echo "not tested against OpenIGTLink's own programs: openigtlink-examples is not installed"
    finished
    exit
fi

# example NAME FILE: compiled to $work/NAME.
example() {
    { [ -f "$examples/$2" ] && cat "$examples/$2" || zcat "$examples/$2.gz"; } >"$work/$1.cxx"
    g++ -w -O0 -I/usr/include/openigtlink "$work/$1.cxx" -lOpenIGTLink -lpthread -o "$work/$1" ||
        fail "$2 does not compile"
}
example tdata_client TrackingData/TrackingDataClient.cxx
example tdata_server TrackingData/TrackingDataServer.cxx
example tracker_server Tracker/TrackerServer.cxx
example tracker_client Tracker/TrackerClient.cxx
example status_server Status/StatusServer.cxx
example receiver Receiver/ReceiveClient.cxx

# theirs NAME ARGUMENTS...: an example runs until it is ended, at most 20 s.
theirs() {
    local name=$1
    shift
    timeout 20 stdbuf -o0 "$work/$name" "$@" >"$work/$name.out" 2>&1 &
    ours+=($!)
}
free_port() { python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'; }

# Their client asks ours for tracking data, hears ten messages and stops.
serve 1
theirs tdata_client 127.0.0.1 "$port" 100
served
python3 - "$work/tdata_client.out" "$work/by_ours" <<'P' || fail "their client did not hear the probe: $(head -c 600 "$work/tdata_client.out")"
import json, re, sys
told = [tuple(json.loads(l)["position_mm"]) for l in open(sys.argv[2]) if '"pose"' in l]
text = open(sys.argv[1]).read()
blocks = re.findall(r"Name +: (\S+)\n Type +: (\d)\n Matrix : \n=+\n(.*?)\n=", text, re.S)
assert blocks and all(name == "probe" and kind == "2" for name, kind, _ in blocks), blocks[:2]
def column(block):
    rows = [[float(x) for x in re.findall(r"-?\d[\d.e+-]*", line)] for line in block.splitlines()[:3]]
    return [row[3] for row in rows]
for _, _, block in blocks:
    at = column(block)
    assert min(max(abs(a - b) for a, b in zip(at, t)) for t in told) < 1e-3, at
assert 5 <= len(blocks) <= 11, len(blocks)
P

# Their receiver asks for nothing, and is told transforms and the status.
serve 4
theirs receiver 127.0.0.1 "$port"
served
grep -q "Receiving TRANSFORM" "$work/receiver.out" || fail "their receiver heard no transform"
grep -q "Receiving STATUS" "$work/receiver.out" || fail "their receiver heard no status"

# Their client that tells transforms to ours disturbs nobody.
serve 0.5
theirs tracker_client 127.0.0.1 "$port" 50
expect 0 "" "$rhexis" igtl listen "localhost:$port" --json --seconds 2  # the probe is taken up in the first one
[ "$(grep -c '"pose"' "$work/stdout")" -gt 10 ] || fail "a peer that tells disturbs who hears"
served

# Ours asks their servers.
tools=$(free_port)
theirs tdata_server "$tools"
poses=$(free_port)
theirs tracker_server "$poses" 50
states=$(free_port)
theirs status_server "$states"
sleep 0.5
expect 0 "" "$rhexis" igtl listen "localhost:$tools" --period 20 --json --seconds 1
python3 - "$work/stdout" <<'P' || fail "their tracking data are not heard: $(head -c 300 "$work/stdout")"
import json, math, sys
lines = [json.loads(line) for line in open(sys.argv[1])]
assert len(lines) <= 3 * 51, len(lines)  # 20 ms apart
channels = [[l["position_mm"] for l in lines if l["device"] == f"Channel {i}"] for i in range(3)]
assert min(map(len, channels)) >= 10, list(map(len, channels))
for i, places in enumerate(channels):  # each goes round by so much more a message
    for n, (x, y, z) in enumerate(places[:10]):
        phi = 0.1 * (i + 1) * n
        assert max(abs(x - 50 * math.cos(phi)), abs(y - 50 * math.sin(phi)), abs(z - x)) < 1e-3, (i, n, x, y, z)
P
expect 0 "" "$rhexis" igtl listen "localhost:$poses" --json --seconds 1
python3 - "$work/stdout" <<'P' || fail "their transforms are not heard: $(head -c 300 "$work/stdout")"
import json, math, sys
lines = [json.loads(line) for line in open(sys.argv[1])]
assert len(lines) >= 10 and all(l["device"] == "Tracker" and l["kind"] == "pose" for l in lines), len(lines)
for n, line in enumerate(lines[:10]):
    x, y, z = line["position_mm"]
    assert max(abs(x - 50 * math.cos(0.2 * n)), abs(y - 50 * math.sin(0.2 * n)), abs(z - x)) < 1e-3, (n, x, y, z)
assert len({round(l["quaternion_xyzw"][1], 3) for l in lines}) > 3, "it does not turn"
P
expect 0 "" "$rhexis" igtl listen "localhost:$states" --json --seconds 0.8
says '"text":"This is a test to send status message."'
finished
