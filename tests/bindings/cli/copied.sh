#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The tests of an exercise hold when a copy of it gets another patient: their files say whose eye their hands know.
set -u
. "$(dirname "$0")/expect.sh"
repository=$PWD
cd "$work" || exit 2  # kept states go to runs/ here

cp -r "$repository/curricula/groove" "$work/my_groove"
sed -i 's/^    patient = {.*},$/    patient = { age = 74, cataract = "NO4", pupil_mm = 6 },/' "$work/my_groove/curriculum.lua"
grep -q 'cataract = "NO4"' "$work/my_groove/curriculum.lua" || fail "README's edit was not made"
expect 0 "" "$rhexis" test "$work/my_groove" --filter iris
expect 0 "" "$rhexis" test "$work/my_groove" --filter "aspiration alone"
sed -i '/^    patient = {/d' "$work/my_groove/tests/depth.lua"
expect 1 "" "$rhexis" test "$work/my_groove" --filter "too deep, put right"
sed -i 's/^return scenarios {/&\n    patient = 74,/' "$work/my_groove/tests/depth.lua"
expect 1 "depth.lua:" "$rhexis" check "$work/my_groove"
cd / || exit 2
finished
