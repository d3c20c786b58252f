#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What is written where: links, pipes and devices as outputs, two runs into one folder, a full disk behind stdout, and
# where states are kept.
set -u
. "$(dirname "$0")/expect.sh"
repository=$PWD
exercise=$repository/docs/examples/exercises/steady_hand
cd "$work" || exit 2
test_to=("$rhexis" test "$exercise" --filter well --junit)

# A link stays a link, and what it points to is replaced; its mode is kept.
echo old >real.xml
chmod 640 real.xml
ln -s real.xml link.xml
ln -s link.xml second.xml
expect 0 "" "${test_to[@]}" second.xml
[ -L second.xml ] && [ -L link.xml ] && grep -q testsuite real.xml || fail "not written through the links"
[ "$(stat -c %a real.xml)" = 640 ] || fail "the mode of a file that is replaced is not kept"
ln -s nowhere/new.xml dangling.xml
expect 2 "there is no folder ./nowhere" "${test_to[@]}" dangling.xml
mkdir nowhere
expect 0 "" "${test_to[@]}" dangling.xml
[ -L dangling.xml ] && [ -s nowhere/new.xml ] || fail "not written where a link points to"
ln -s b.xml a.xml
ln -s a.xml b.xml
expect 2 "its links go in circles" "${test_to[@]}" a.xml
expect 2 "this is a folder" "${test_to[@]}" nowhere

# What is no plain file is written to directly and stays what it is.
mkfifo pipe
timeout 60 cat pipe >through &
reader=$!
expect 0 "" "${test_to[@]}" pipe
wait $reader
[ -p pipe ] && grep -q testsuite through || fail "not written through a pipe"
ln -s /proc/self/fd/1 stdout.xml
expect 0 "" "${test_to[@]}" stdout.xml
says "<testsuite"
[ -L stdout.xml ] || fail "a link to stdout has become a file"
if [ "$(id -u)" = 0 ] && mknod -m 666 null c 1 3 2>/dev/null && { : >null; } 2>/dev/null; then
    expect 0 "" "${test_to[@]}" null
    [ -c null ] || fail "a device has become a file"
fi

# One run at a time in a folder; a run that was killed does not stand in the way.
long=("$rhexis" run groove --surgeon none --no-pictures --set patient.tetrahedra=500 --out shared)
"${long[@]}" --limit 600 --seed 1 >first.txt 2>&1 &
first=$!
for _ in $(seq 200); do [ -s shared/recording.rhx.part ] && break; sleep 0.05; done
expect 2 "shared: another run writes into this folder (process $first)" "${long[@]}" --limit 0.1 --seed 2
[ -z "$(find shared -name report.json)" ] || fail "the run that was refused wrote something"
kill -9 $first
wait $first 2>/dev/null
expect 0 "" "${long[@]}" --limit 0.1 --seed 2
grep -q '"seed": 2' shared/report.json || fail "no report of the run after the one that was killed"
expect 2 "no_such_exercise" "$rhexis" run no_such_exercise --out never
[ ! -e never ] || fail "a run that could not start left a folder"

# What was printed did not arrive: a line and a status.
full=(bash -c '"$@" >/dev/full' _)
echo 'for i = 1, 20000 do print(i) end' >many.lua
echo 'print("x") os.exit(0)' >leaves.lua
for command in "words $exercise" "check $exercise" "lua many.lua" "lua leaves.lua" "--version" "run --help"; do
    # shellcheck disable=SC2086
    expect 2 "not all of the output could be written" "${full[@]}" "$rhexis" $command
done
expect 2 "not all of the output could be written" "${full[@]}" "$rhexis" run "$exercise" --surgeon none --limit 0.1 \
    --no-pictures --json --out json
# A pipe that nobody reads, where the signal that comes with it is ignored as many callers do.
broken() { (trap '' PIPE; "$@" 2>broken.txt | true; echo "${PIPESTATUS[0]}"); }
[ "$(broken "$rhexis" lua many.lua)" = 2 ] || fail "a closed pipe goes unnoticed"
grep -q "not all of the output could be written" broken.txt || fail "nothing is said of a closed pipe"

# States are kept in the cache, wherever one stands; where none can be written there is a folder of this user alone.
mine=(env -u XDG_CACHE_HOME -u RHEXIS_CACHE)
cp -r "$exercise" mine
cat >mine/starts.lua <<'L'
return starts { soon = { function(t) t:wait(0.1) end } }
L
run=("$rhexis" run mine --surgeon none --limit 0.1 --no-pictures --start soon)
kept() { find "$1" -name 'mine-soon-*.rhxs' 2>/dev/null | grep -q . || fail "no state in $1"; }
expect 0 "" "${run[@]}" --out kept_1 --cache given
kept given/states
expect 0 "" "${mine[@]}" RHEXIS_CACHE="$work/named" "${run[@]}" --out kept_2
kept named/states
expect 0 "" "${mine[@]}" XDG_CACHE_HOME="$work/xdg" "${run[@]}" --out kept_3
kept xdg/rhexis/states
expect 0 "" "${mine[@]}" HOME="$work/home" "${run[@]}" --out kept_4
kept home/.cache/rhexis/states
mkdir temporary
expect 0 "" "${mine[@]}" HOME=/proc/none TMPDIR="$work/temporary" "${run[@]}" --out kept_5
kept "temporary/rhexis-$(id -u)/states"
expect 2 "cannot make this folder" "${mine[@]}" RHEXIS_CACHE=/proc/none "${run[@]}" --out kept_6
[ ! -e runs ] || fail "something is kept in the working folder"

# Byte order marks, and what only looks like a space.
printf '\xef\xbb\xbfprint("marked")\n' >marked.lua
expect 0 "" "$rhexis" lua marked.lua
says marked
printf 'print(1)\rprint("old ends of lines")\r' >old.lua
expect 0 "" "$rhexis" lua old.lua
says "old ends of lines"
printf 'print(1)\nlocal a\xc2\xa0= 1\n' >nbsp.lua
expect 1 "nbsp.lua:2: unexpected symbol near '<\194>': a no-break space stands there" "$rhexis" lua nbsp.lua
printf 'local a\xa0= 1\n' >latin.lua
expect 1 "a no-break space stands there" "$rhexis" lua latin.lua
odd="a?b;c%d"
mkdir "$odd"
echo 'return { word = "found" }' >"$odd/part.lua"
echo 'print(require("part").word)' >"$odd/main.lua"
expect 0 "" "$rhexis" lua "$odd/main.lua"
says found
cp -r "$exercise" "$odd/exercise"
expect 0 "" "$rhexis" check "$odd/exercise"
mkdir -m 000 closed
if [ "$(id -u)" != 0 ]; then
    expect 2 "Permission denied" "$rhexis" run "$exercise" --patient closed/patient.json --out p
fi

finished
