#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Whatever is wrong with what the user gives: one clear line and status 1 or 2, never a crash or a hang.
set -u
. "$(dirname "$0")/expect.sh"
quick=(--limit 0.3 --no-pictures --out "$work/out" --set patient.tetrahedra=500)

# Usage.
expect 2 "there is no command rnu (did you mean run?)" "$rhexis" rnu
expect 2 "there is no option --sead (did you mean --seed" "$rhexis" run groove --sead 3
expect 2 "there is no option --windo (did you mean --window?)" "$rhexis" track my_rig/track.json --windo
expect 2 "track: there is no command calibarte (did you mean calibrate?)" "$rhexis" track calibarte my_rig/track.json
expect 2 "curriculum is required" "$rhexis" run
expect 2 "rhexis --help shows what there is" "$rhexis"
expect 2 "--threads" "$rhexis" run groove --threads 0
expect 2 "--instruction-set: sse9 not in {baseline,avx2,avx512}" "$rhexis" run groove --instruction-set sse9
expect 2 "--instruction-set: sse9 not in {baseline,avx2,avx512}" "$rhexis" replay nowhere.rhx --instruction-set sse9
expect 2 "--limit is nan (0.1 to 7200)" "$rhexis" run groove --no-pictures --out "$work/out" --limit nan
expect 2 "--limit is 0.01 (0.1 to 7200)" "$rhexis" run groove --no-pictures --out "$work/out" --limit 0.01
expect 2 "--seed = abc" "$rhexis" run groove --seed abc
expect 2 "--set age has no value" "$rhexis" run groove --set age

# Names.
expect 2 "did you mean 'groove'?" "$rhexis" run grove "${quick[@]}"
expect 2 "expret" "$rhexis" run groove --surgeon expret "${quick[@]}"
expect 2 "goal.lenght_mm" "$rhexis" run groove --set goal.lenght_mm=3 "${quick[@]}"

# Values.
expect 2 "patient.age" "$rhexis" run groove "${quick[@]}" --set patient.age=12
expect 2 "patient.pupil_mm" "$rhexis" run groove "${quick[@]}" --set patient.pupil_mm=nan
expect 2 "settings.phaco.power_limit is 7 (0 to 1)" "$rhexis" run groove "${quick[@]}" --set phaco.power_limit=7
expect 2 "phaco.power_limit must be a number" "$rhexis" run groove "${quick[@]}" --set phaco.power_limit=nan
expect 2 "goal.length_mm must be a number" "$rhexis" run groove "${quick[@]}" --set goal.length_mm=inf
expect 2 "goal.length_mm" "$rhexis" run groove "${quick[@]}" --set goal.length_mm=99
expect 2 "step_s" "$rhexis" run groove "${quick[@]}" --set step_s=1
echo '{"age": 300}' >"$work/patient.json"
expect 2 "age is 300" "$rhexis" run groove "${quick[@]}" --patient "$work/patient.json"
echo '{"aeg": 30}' >"$work/patient.json"
expect 2 "aeg" "$rhexis" run groove "${quick[@]}" --patient "$work/patient.json"
echo '{"age": 1e999}' >"$work/patient.json"
expect 2 "patient.json: holds a number beyond all range" "$rhexis" run groove "${quick[@]}" --patient "$work/patient.json"
head -c 100000 /dev/zero | tr '\0' '[' >"$work/patient.json"
expect 2 "patient.json:1: is not JSON" "$rhexis" run groove "${quick[@]}" --patient "$work/patient.json"
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

# Scripts that go wrong while they are read: nothing is begun.
never_starts() { # never_starts TEXT 'CURRICULUM'
    local folder
    folder=$(printf '%b' "$2" | exercise wrong)
    expect 2 "$1" "$rhexis" run "$folder" "${quick[@]}"
    expect 1 "$1" "$rhexis" check "$folder"
    [ ! -e "$work/out" ] || fail "an exercise that could not be read left $(ls "$work/out")"
}
rm -rf "$work/out"
never_starts "wrong/curriculum.lua:3: '}' expected" 'return exercise {\n  title = "x"\n  tissues = {},\n}\n'
never_starts "wrong/curriculum.lua:2: stopped: used up its budget" 'local x = 1\nwhile true do end\n'
never_starts "wrong/curriculum.lua:1: stopped: needs more memory" 'local t = {} while true do t[#t + 1] = ("x"):rep(1e6) .. #t end\n'
never_starts "wrong/curriculum.lua:1: stopped: needs more memory" 'local function f() return f() + 1 end f()\n'
never_starts "wrong/curriculum.lua:2: patient: age must be a number" 'return exercise { title = "x", tissues = {}, instruments = {},\n  patient = { age = 0 / 0 }, steps = { step "a" { done = "time_s > 1" } } }\n'
never_starts "wrong/curriculum.lua:1: is precompiled" '\x1bLua\n'
never_starts "a curriculum must end with: return exercise" 'return 7\n'
never_starts "wrong/curriculum.lua:2: “ is a quotation mark of a word processor: write straight ones" 'return exercise {\n title = “x”,\n}\n'
never_starts "wrong/curriculum.lua:2: there is no word 'stepp' (did you mean step?)" 'return exercise {\n steps = { stepp "a" {} } }\n'
never_starts "wrong/curriculum.lua:1: exercise: title holds the control character \\27" 'return exercise { title = "a\\27[31m", tissues = {}, instruments = {},\n steps = { step "a" { done = "time_s > 1" } } }\n'
never_starts "error with a table instead of a message" 'error({})\n'
mkdir "$work/nothing"
expect 2 "nothing: the folder holds no curriculum.lua" "$rhexis" run "$work/nothing" "${quick[@]}"

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

# A script of a step that gives what cannot be taken: it ends there, and nothing is set, said or waited for.
gives() { # gives TEXT 'CALL'
    local folder
    folder=$(exercise gives <<L
return exercise {
    title = "gives", patient = { tetrahedra = 500 }, tissues = { "lens" }, instruments = { "phaco" },
    steps = { step "speak" { script = function(_, act)
        $2
    end } },
}
L
)
    expect 1 "gives/curriculum.lua:4: $1" "$rhexis" run "$folder" --surgeon none --limit 0.3 --no-pictures --out "$work/out"
    grep -qF "curriculum.lua:4: $1" "$work/out/report.json" || fail "the report does not say: $1"
}
gives "act.set: there is no setting 'phaco.power_limt' (did you mean phaco.power_limit?) (in step 'speak')" 'act.set("phaco.power_limt", 1)'
gives "act.set: phaco.power_limit = 7 is out of range (0 to 1)" 'act.set("phaco.power_limit", 7)'
gives "act.wait must be a number of seconds, 0 or more, not nan" 'act.wait(0/0)'
gives "act.say must be a text in quotes, not nil" 'act.say(nil)'

# rhexis lua.
echo 'print(' >"$work/wrong.lua"
expect 1 "wrong.lua:" "$rhexis" lua "$work/wrong.lua"
echo 'error("no")' >"$work/raises.lua"
expect 1 "raises.lua:1: no" "$rhexis" lua "$work/raises.lua"
expect 2 "nowhere.lua" "$rhexis" lua "$work/nowhere.lua"

# Meshes: the element, and the line of the file.
mesh() { # mesh NODES OF ITS SECOND TETRAHEDRON
    cat <<M
# vtk DataFile Version 2.0
two tetrahedra
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 5 double
0 0 0  1 0 0  0 1 0  0 0 1  1 1 1
CELLS 2 10
4 0 1 2 3
4 $*
CELL_TYPES 2
10 10
M
}
echo 'print(rhexis.mesh.read(arg[1]):info().tetrahedra)' >"$work/mesh.lua"
mesh 1 2 3 4 >"$work/good.vtk"
expect 0 "" "$rhexis" lua "$work/mesh.lua" "$work/good.vtk"
mesh 2 1 3 4 >"$work/inverted.vtk"
expect 1 "inverted.vtk:9: tetrahedron 1 is inverted" "$rhexis" lua "$work/mesh.lua" "$work/inverted.vtk"
mesh 1 2 3 9 >"$work/far.vtk"
expect 1 "far.vtk:9: tetrahedron 1" "$rhexis" lua "$work/mesh.lua" "$work/far.vtk"
mesh 1 2 3 4 | head -c 150 >"$work/cut.vtk"
expect 1 "cut.vtk:" "$rhexis" lua "$work/mesh.lua" "$work/cut.vtk"
head -c 5000 /dev/urandom >"$work/noise.vtk"
expect 1 "noise.vtk:" "$rhexis" lua "$work/mesh.lua" "$work/noise.vtk"
expect 1 "nowhere.vtk" "$rhexis" lua "$work/mesh.lua" "$work/nowhere.vtk"

# Recordings.
expect 2 "cannot read: No such file" "$rhexis" replay "$work/nowhere.rhx"
head -c 5000 /dev/urandom >"$work/foreign.rhx"
expect 2 "this is not a recording" "$rhexis" replay "$work/foreign.rhx"
: >"$work/empty.rhx"
expect 2 "empty.rhx: the file is empty" "$rhexis" replay "$work/empty.rhx" --verify
printf 'rhexis recording 99\n....' >"$work/other.rhx"
expect 2 "format version 99" "$rhexis" replay "$work/other.rhx" --verify
expect 2 "there is no" "$rhexis" bench no_such_benchmark
expect 2 "report.json" "$rhexis" report "$work"
echo '{' >"$work/report.json"
expect 2 "this is no JSON object" "$rhexis" report "$work"
echo '{}' >"$work/report.json"
expect 2 "the report is not of schema 1" "$rhexis" report "$work"

# No device to draw with (the run itself: run_and_replay.sh).
blind=(env __EGL_VENDOR_LIBRARY_DIRS=/nonexistent __EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent)
cat >"$work/draw.lua" <<'L'
local scene = rhexis.scene.create()
scene:add_solid { mesh = rhexis.mesh.bar() }
local view = { eye = { 4, -60, 25 }, target = { 4, 1, 0 }, up = { 0, 0, 1 }, field = 8 }
rhexis.render.draw(scene, { camera = view }):write_png(arg[1])
L
expect 0 "" "$rhexis" lua "$work/draw.lua" "$work/picture.png"
rm "$work/picture.png"
expect 1 "draw.lua:4:" "${blind[@]}" "$rhexis" lua "$work/draw.lua" "$work/picture.png"
expect 1 "draw.lua:4:" "$rhexis" lua "$work/draw.lua" "$work/no_such_folder/picture.png"
[ ! -e "$work/picture.png" ] || fail "a picture without a device"
finished
