#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The tracking computer as its users meet it: begun, calibrated, tracked, heard over the network, wrong files.
set -u
program=$1
work=$(mktemp -d)
trap 'kill $(jobs -p) 2> /dev/null; rm -rf "$work"' EXIT
failed=0
wrong() { echo "WRONG: $*"; failed=1; }
# refused WHAT WORDS...: the command fails with 2 and one line that has these words
refused() {
  local words=$1; shift
  "$@" > "$work/out" 2> "$work/err"
  local status=$?
  [ $status = 2 ] || wrong "$* ends with $status, not 2"
  [ "$(wc -l < "$work/err")" = 1 ] || wrong "$* says: $(cat "$work/err")"
  grep -q -- "$words" "$work/err" || wrong "$* does not say '$words' but: $(cat "$work/err")"
}
cd "$work" || exit 1

"$program" track begin rig > begun || wrong "begin fails"
grep -q "track calibrate rig/track.json" begun || wrong "begin does not say what is next"
refused "cannot be begun in" "$program" track begin rig
refused "not calibrated" "$program" track rig/track.json
sed -i 's/"clip": "tremor"/"clip": "tremor", "level": "markers"/; s/"vrpn": 3883/"vrpn": 0/' rig/track.json

cp -r rig onecore
"$program" track calibrate rig/track.json > calibrated || wrong "calibrate fails"
residual=$(sed -n 's/.*residual \([0-9.]*\) pixels.*/\1/p' calibrated)
awk "BEGIN { exit !($residual > 0 && $residual < 0.05) }" || wrong "calibrated to $residual pixels"
OPENBLAS_NUM_THREADS=1 "$program" track calibrate onecore/track.json > calibrated || wrong "calibrate fails"
cmp rig/rig.json onecore/rig.json || wrong "on one core a rig is calibrated to other digits"
grep -q "<svg" rig/calibration.html || wrong "no page of the calibration"
grep -q '"calibrated": true' rig/rig.json || wrong "the rig does not say that it is calibrated"

"$program" track rig/track.json --seconds 0.5 --fast --silent --json > poses 2> lines || wrong "track fails"
tail -1 poses | python3 -c '
import json, sys
bodies = json.load(sys.stdin)["bodies"]
assert list(sorted(bodies)) == ["head", "phaco", "spatula"] and all(b["seen"] == "seen" and b["cameras"] >= 5 for b in bodies.values()), bodies
' || wrong "not all bodies are seen"
grep -q "phaco is seen" lines || wrong "it does not say what is seen"
"$program" track rig/track.json --seconds 0.1 --fast --silent --picture seen.png 2> /dev/null || wrong "no picture"
[ "$(head -c 8 seen.png | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a ] || wrong "the picture is no PNG"

# What the cameras see, in a window; what keys and clicks do there, tests of the window say.
export SDL_VIDEODRIVER=offscreen LIBGL_ALWAYS_SOFTWARE=1
"$program" track rig/track.json --seconds 1 --silent --window --width 900 --height 640 --screenshot shown.png 2> window_said || wrong "no window: $(cat window_said)"
python3 - <<'P' || wrong "the window's picture is not that of a window"
import struct
png = open("shown.png", "rb").read()
assert struct.unpack(">II", png[16:24]) == (900, 640) and len(png) > 15000, (png[16:24], len(png))  # letters and spots
P
refused "there is none" "$program" track rig/track.json --screenshot shown.png
refused "no window" env -u DISPLAY -u WAYLAND_DISPLAY SDL_VIDEODRIVER=x11 "$program" track rig/track.json --window
# Where a tip is, by turning it: found to a tenth of a millimetre, with how sure that is; not without turning.
sed 's/"tremor"/"pivot"/' rig/track.json > rig/pivot.json
cp rig/phaco.json phaco.json
refused "turned least is spread by" "$program" track pivot rig/track.json phaco --seconds 2
cmp -s rig/phaco.json phaco.json || wrong "a pivot that was refused changed the body"
"$program" track pivot rig/pivot.json phaco --seconds 3 > pivoted || wrong "pivot fails"
grep -q "to 0.0[0-9]* mm" pivoted || wrong "pivot does not say how sure it is: $(cat pivoted)"
python3 -c '
import json
is_, was = (json.load(open(name))["tip_mm"] for name in ("rig/phaco.json", "phaco.json"))
assert 0 < max(abs(a - b) for a, b in zip(is_, was)) < 0.1, (is_, was)
' || wrong "the tip is elsewhere"
cp phaco.json rig/phaco.json

# Heard by another process, and a second server at the same place is refused.
"$program" track rig/track.json --seconds 6 2> told &
for _ in $(seq 50); do grep -q "told at" told && break; sleep 0.1; done
port=$(sed -n 's/.*127.0.0.1:\([0-9]*\) (VRPN).*/\1/p' told)
"$program" vrpn listen "tcp://127.0.0.1:$port" phaco spatula --seconds 2 --json > heard 2> /dev/null
[ "$(grep -c '"kind":"pose"' heard)" -gt 100 ] || wrong "heard only $(grep -c pose heard) poses"
sed "s/\"vrpn\": 0/\"vrpn\": $port/" rig/track.json > rig/same.json
refused "$port" "$program" track rig/same.json --seconds 1
wait

# Images are kept, and tracked again to the same poses.
sed 's/"markers"/"images"/' rig/track.json > rig/images.json
"$program" track rig/images.json --seconds 0.03 --fast --silent --json --keep shots > first 2> /dev/null || wrong "images are not kept"
sed 's/"source": {[^}]*}/"source": {"kind": "folder", "path": "..\/shots"}/' rig/track.json > rig/folder.json
"$program" track rig/folder.json --fast --silent --json > again 2> /dev/null || wrong "kept images are not tracked"
python3 - <<'P' || wrong "kept images give other poses"
import json
first, again = ([json.loads(line)["bodies"] for line in open(name)] for name in ("first", "again"))
assert len(first) == len(again) >= 3
for a, b in zip(first, again):
    for name in a:
        off = max(abs(x - y) for x, y in zip(a[name]["tip_mm"], b[name]["tip_mm"]))
        assert off < 0.02, (name, off)  # the clock of the folder is not that of the rig to the microsecond
P
rm -rf shots/camera3
refused "camera3" "$program" track rig/folder.json --silent
mkdir shots/camera3
printf 'P5\n8 8\n255\n%064d' 0 > shots/camera3/000000.pgm
refused "8 x 8" "$program" track rig/folder.json --silent
sed 's/"source": {[^}]*}/"source": {"kind": "cameras", "devices": ["97","98","99","94","95","96"]}/' rig/track.json > rig/cameras.json
refused "cannot be opened" "$program" track rig/cameras.json --silent

# Pedal and jaws of another server are told by this one, which tells where the instruments are.
"$program" run navigation --surgeon d --no-pictures --limit 1 --out run > /dev/null || wrong "nothing to serve"
"$program" vrpn serve run --port 0 > served 2> /dev/null &
for _ in $(seq 100); do grep -q "^at " served && break; sleep 0.1; done
other=$(sed -n 's/^at [0-9.]*:\([0-9]*\): .*/\1/p' served)
sed "s/\"serve\"/\"inputs\": {\"vrpn\": \"127.0.0.1:$other\"}, \"serve\"/" rig/track.json > rig/inputs.json
"$program" track rig/inputs.json --seconds 4 2> told &
for _ in $(seq 50); do grep -q "told at" told && break; sleep 0.1; done
port=$(sed -n 's/.*127.0.0.1:\([0-9]*\) (VRPN).*/\1/p' told)
"$program" vrpn listen "127.0.0.1:$port" phaco pedal --seconds 2.5 --json > heard 2> /dev/null
grep '"device":"pedal"' heard | grep -q '"kind":"analog"' || wrong "the pedal of the inputs is not told"
grep -q '"by":"udp".*"device":"phaco".*"kind":"pose"' heard || wrong "no pose is told by datagram"
wait
sed 's/127.0.0.1:[0-9]*"}/nowhere"}/' rig/inputs.json > rig/wrong.json
refused "inputs\": vrpn: no VRPN server: 'nowhere'" "$program" track rig/wrong.json

# Files that are wrong.
refused "does not exist" "$program" track nowhere.json
refused "nothing to track" "$program" track
change() { sed "$1" rig/track.json > rig/wrong.json; }
change 's/"head": "head"/"head": "nobody"/'; refused "nobody" "$program" track rig/wrong.json
change 's/"serve"/"sevre"/'; refused "did you mean 'serve'" "$program" track rig/wrong.json
change 's/127.0.0.1/0.0.0.0/'; refused "others_may_hear" "$program" track rig/wrong.json
change 's/"tremor"/"trembling"/'; refused "trembling" "$program" track rig/wrong.json
change 's/"spatula.json"/"spatula.json", "twin.json"/'
sed 's/"spatula"/"twin"/' rig/spatula.json > rig/twin.json
refused "twin" "$program" track rig/wrong.json
change 's/"rig.json"/"two.json"/'
python3 -c 'import json; r = json.load(open("rig/rig.json")); r["cameras"] = r["cameras"][:1]; json.dump(r, open("rig/two.json", "w"))'
refused "1 cameras" "$program" track rig/wrong.json
refused "no body" "$program" track pivot rig/track.json scalpel

# What another exercise is done with, or all parts of an operation.
"$program" track begin rhexis --exercise capsulorhexis > /dev/null || wrong "begin fails for another exercise"
[ "$(ls rhexis | tr '\n' ' ')" = "cannula.json cystotome.json forceps.json head.json rig.json track.json " ] ||
  wrong "another exercise is begun with $(ls rhexis)"
"$program" track begin whole --exercise full_operation > /dev/null || wrong "begin fails for an operation"
[ "$(ls whole | wc -l)" -gt 15 ] || wrong "an operation is begun with $(ls whole)"
sed -i 's/"clip": "tremor"/"clip": "still", "level": "markers"/' whole/track.json
sed -i 's/"calibrated": false/"calibrated": true/' whole/rig.json
"$program" track whole/track.json --seconds 0.1 --fast --silent 2> /dev/null || wrong "the bodies of an operation are not tracked"
refused "no_such_exercise" "$program" track begin other --exercise no_such_exercise
[ ! -e other ] || wrong "a folder is made for an exercise that there is not"

# Replicas, and a body for another instrument.
for body in head phaco forceps; do
  "$program" track print "$(ls {rig,rhexis}/$body.json 2> /dev/null | head -1)" $body.stl || wrong "$body is not printed"
  [ "$(wc -c < $body.stl)" -gt 10000 ] || wrong "an empty shape of $body"
done
"$program" track print rig/phaco.json sleeve.stl --without-shape || wrong "no sleeve alone"
[ "$(wc -c < sleeve.stl)" -lt "$(wc -c < phaco.stl)" ] || wrong "the sleeve alone is no smaller"
refused "twin" "$program" track print rig/twin.json twin.stl
"$program" track print rig/twin.json twin.stl --without-shape || wrong "no sleeve for an instrument that is not known"
"$program" track design hook hook.json --unlike rig/phaco.json --beside rig/head.json > /dev/null || wrong "nothing is designed"
sed 's/"rig.json"/"..\/rig\/rig.json"/; s/\["[^]]*\]/["..\/rig\/head.json", "..\/rig\/phaco.json", "..\/hook.json"]/' rig/track.json > whole/hook.json
"$program" track whole/hook.json --seconds 0.1 --fast --silent 2> /dev/null || wrong "what was designed is not tracked"
refused "scalpel" "$program" track design scalpel scalpel.json

# Lenses by a board, from images that are kept and looked at once more; what does not do leaves the rig as it is.
refused "is no board" "$program" track lenses rig/track.json --board dots:13x9
refused "does not fit into the image" "$program" track lenses rig/track.json --board dots:13x9x90
"$program" track lenses rig/track.json --board dots:9x7x18 --views 9 --keep boards > lenses || wrong "lenses fails"
[ "$(grep -c ': residual 0.0[0-9]* pixels' lenses)" = 6 ] || wrong "not six lenses: $(cat lenses)"
grep -q "Where each image saw the board" rig/calibration.html || wrong "no page of the lenses"
refused "not calibrated" "$program" track rig/track.json --silent
"$program" track calibrate rig/track.json > calibrated || wrong "calibrate fails after lenses"
residual=$(sed -n 's/.*: residual \([0-9.]*\) pixels.*/\1/p' calibrated)
awk "BEGIN { exit !($residual > 0 && $residual < 0.05) }" || wrong "calibrated to $residual pixels with lenses by boards"
grep -q "Lenses, by a board" rig/calibration.html || wrong "the page forgets the lenses"
cp rig/rig.json kept.json
rm -f boards/camera2/00000[2-8].png
refused 'camera "camera2", lens: only 2 views' "$program" track lenses rig/track.json --board dots:9x7x18 --images boards
refused 'camera "camera1": no board of 9 x 8 dots' "$program" track lenses rig/track.json --board dots:9x8x18 --images boards
printf 'P5\n8 8\n255\n%064d' 0 > boards/camera3/000001.pgm
rm boards/camera3/000001.png
refused "8 x 8" "$program" track lenses rig/track.json --board dots:9x7x18 --images boards
cmp -s rig/rig.json kept.json || wrong "lenses that were not found changed the rig"
sed 's/"seed": 1/"seed": 1, "seconds": 1/' rig/track.json > rig/short.json
refused "frames in which two cameras see the whole wand" "$program" track calibrate rig/short.json --seconds 1
cmp -s rig/rig.json kept.json || wrong "a wand that was too short changed the rig"

[ $failed = 0 ] && echo "all as it should be"
exit $failed
