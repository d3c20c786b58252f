#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Whatever is wrong with what the user gives: one clear line and status 1 or 2, never a crash or a hang.
set -u
. "$(dirname "$0")/expect.sh"
quick=(--limit 0.3 --no-pictures --out "$work/out" --set patient.tetrahedra=500)

# Usage.
expect 2 "there is no command rnu (did you mean run?)" "$rhexis" rnu
expect 2 "there is no option --sead (did you mean --seed" "$rhexis" run groove --sead 3
expect 2 "curriculum is required" "$rhexis" run
expect 2 "rhexis --help shows what there is" "$rhexis"
expect 2 "--threads" "$rhexis" run groove --threads 0
expect 2 "--instruction-set: sse9 not in {baseline,avx2,avx512}" "$rhexis" run groove --instruction-set sse9
expect 2 "--instruction-set: sse9 not in {baseline,avx2,avx512}" "$rhexis" replay nowhere.rhx --instruction-set sse9
expect 2 "--set age has no value" "$rhexis" run groove --set age

# Names.
expect 2 "did you mean 'groove'?" "$rhexis" run grove "${quick[@]}"
expect 2 "expret" "$rhexis" run groove --surgeon expret "${quick[@]}"
expect 2 "goal.lenght_mm" "$rhexis" run groove --set goal.lenght_mm=3 "${quick[@]}"

# Values.
expect 2 "patient.age" "$rhexis" run groove "${quick[@]}" --set patient.age=12
expect 2 "patient.pupil_mm" "$rhexis" run groove "${quick[@]}" --set patient.pupil_mm=nan
expect 2 "settings.phaco.power_limit is 7 (0 to 1)" "$rhexis" run groove "${quick[@]}" --set phaco.power_limit=7
expect 2 "step_s" "$rhexis" run groove "${quick[@]}" --set step_s=1
echo '{"age": 300}' >"$work/patient.json"
expect 2 "age is 300" "$rhexis" run groove "${quick[@]}" --patient "$work/patient.json"
echo '{"aeg": 30}' >"$work/patient.json"
expect 2 "aeg" "$rhexis" run groove "${quick[@]}" --patient "$work/patient.json"
echo '{' >"$work/patient.json"
expect 2 "patient.json" "$rhexis" run groove "${quick[@]}" --patient "$work/patient.json"
expect 2 "nowhere.json" "$rhexis" run groove "${quick[@]}" --patient "$work/nowhere.json"

# Scripts that are wrong from the start.
broken=$(exercise broken <<'L'
return exercise {
    title = "broken"
    tissues = { "lens" },
}
L
)
expect 2 "curriculum.lua:3:" "$rhexis" run "$broken" "${quick[@]}"
expect 1 "curriculum.lua:3:" "$rhexis" check "$broken"
[ ! -e "$work/out/report.json" ] || fail "an exercise that never started left a report"

small() { # small NAME 'BODY OF THE CONDITION'
    exercise "$1" <<L
local function condition(eye)
    $2
end
return exercise {
    title = "$1",
    patient = { tetrahedra = 500 },
    tissues = { "lens" },
    instruments = { "phaco" },
    steps = { step "look" { done = condition } },
}
L
}
# Scripts that go wrong while they run: the exercise stops, its recording and report stay.
runs_wild() { # runs_wild NAME TEXT 'BODY'
    local folder
    folder=$(small "$1" "$3")
    rm -rf "$work/out"
    expect 1 "$2" "$rhexis" run "$folder" --surgeon none --limit 0.3 --no-pictures --out "$work/out"
    [ -s "$work/out/report.json" ] || fail "$1: no report"
    grep -q '"error"' "$work/out/report.json" || fail "$1: the report does not name the error"
    expect 0 "" "$rhexis" replay "$work/out" --verify
    expect 1 "$2" "$rhexis" check "$folder"
}
runs_wild nil_value "curriculum.lua:2:" 'return eye.phaco.nothing.more'
runs_wild endless "curriculum.lua:2:" 'while true do end'
runs_wild swallowed "curriculum.lua:2:" 'while true do pcall(function() while true do end end) end'
runs_wild memory "not enough memory" 'local t = {} while true do t[#t + 1] = ("x"):rep(1000000) .. #t end'
runs_wild finaliser "curriculum.lua:2:" 'setmetatable({}, { __gc = function() while true do end end })'
runs_wild pattern "curriculum.lua:2:" 'return (("a"):rep(200000)):find((".-"):rep(30) .. "b") ~= nil'
runs_wild system "curriculum.lua:2:" 'os.execute("true")'

# rhexis lua.
echo 'print(' >"$work/wrong.lua"
expect 1 "wrong.lua:" "$rhexis" lua "$work/wrong.lua"
echo 'error("no")' >"$work/raises.lua"
expect 1 "raises.lua:1: no" "$rhexis" lua "$work/raises.lua"
expect 2 "nowhere.lua" "$rhexis" lua "$work/nowhere.lua"

# Recordings.
expect 2 "cannot read: No such file" "$rhexis" replay "$work/nowhere.rhx"
head -c 5000 /dev/urandom >"$work/foreign.rhx"
expect 2 "this is not a recording" "$rhexis" replay "$work/foreign.rhx"
printf 'rhexis recording 7\n....' >"$work/other.rhx"
expect 2 "format version 7" "$rhexis" replay "$work/other.rhx" --verify
expect 2 "there is no" "$rhexis" bench no_such_benchmark
expect 2 "report.json" "$rhexis" report "$work"
finished
