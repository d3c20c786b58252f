#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# rhexis fold: bad input leaves one clear line and no file.
set -u
. "$(dirname "$0")/expect.sh"
out=(--out "$work/lens.rhxs")

expect 2 "--out is required" "$rhexis" fold
expect 2 "cartridge.bore_mm is 1.6, too small for the implant (at least 2.45 for this lens)" \
    "$rhexis" fold "${out[@]}" --set cartridge.bore_mm=1.6
expect 2 "settings.implant.centre_mm is -0.2 (0.1 to 2)" "$rhexis" fold "${out[@]}" --set implant.centre_mm=-0.2
expect 2 "nozzle is 3 (1 to 2.8 mm)" "$rhexis" fold "${out[@]}" --set cartridge.nozzle_mm=3
expect 2 "phaco.duty=1 is no setting of implant or cartridge" "$rhexis" fold "${out[@]}" --set phaco.duty=1
expect 2 "implant.thickness" "$rhexis" fold "${out[@]}" --set implant.thickness=1
expect 2 "cannot make this folder" "$rhexis" fold --out /proc/nowhere/lens.rhxs
expect 2 "cannot make this folder" "$rhexis" fold "${out[@]}" --pictures /proc/nowhere
[ ! -e "$work/lens.rhxs" ] || fail "a fold that was refused left a state"
finished
