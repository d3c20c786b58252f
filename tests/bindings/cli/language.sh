#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Exercises in French: --language and LANG, the report, replay; level, mode, eye and hand of a run.
set -u
. "$(dirname "$0")/expect.sh"
short=(--limit 0.5 --no-pictures)
unset LC_ALL LC_MESSAGES
# run LANG OUT OPTIONS...: as a command, for expect.
cat >"$work/run" <<R
#!/usr/bin/env bash
LANG=\$1 exec "$rhexis" run capsulorhexis ${short[*]} --out "$work/\$2" "\${@:3}"
R
chmod +x "$work/run"
report_has() { grep -qF -- "$2" "$work/$1/report.json" || fail "$1/report.json lacks $2"; }

expect 0 "" "$work/run" fr_FR.UTF-8 french
says "objective  Voir filer une déchirure en dehors tant qu'elle peut encore être corrigée"
report_has french '"language": "fr"'
report_has french '"title": "Remplir la chambre"'
grep -qF "Note, critère par critère" "$work/french/report.html" || fail "the page is not French"
expect 0 "" "$rhexis" replay "$work/french" --verify
expect 0 "" "$work/run" fr_FR.UTF-8 english --language en
says "objective  See a tear"
expect 0 "" "$work/run" de_DE.UTF-8 german  # no texts: English
says "objective  See a tear"
expect 0 "" "$work/run" C chosen --language fr
says "objective  Voir filer"
# the words change nothing that is simulated
hash_of() { grep -o '"state_hash": "[0-9a-f]*"' "$work/$1/report.json"; }
[ "$(hash_of french)" = "$(hash_of english)" ] || fail "the language changes the simulation"
expect 2 "--language xx: there are no texts in 'xx' (did you mean en or fr?)" "$work/run" C wrong --language xx

# The whole operation and its parts lack no French text.
for texts in curricula/*/curriculum.fr.lua; do
  expect 0 "" "$rhexis" check "$(dirname "$texts")"
  ! grep "no text in fr" "$work/stdout" || fail "$texts is not complete"
done
for part in $(grep -o 'part "[a-z_]*"' curricula/full_operation/curriculum.lua | cut -d'"' -f2); do
  [ -f "curricula/$part/curriculum.fr.lua" ] || fail "$part has no French texts"
done

# What has no translation is listed, and is no fault.
mkdir -p "$work/mine"
cat >"$work/mine/curriculum.lua" <<'L'
return exercise {
    title = "Touch", patient = { tetrahedra = 500 }, tissues = { "lens" }, instruments = { "phaco" },
    steps = { step "look" { title = "Look at it", done = "time_s > 1" } },
    texts = { fr = { ["Look at it"] = "Regardez" } },
}
L
echo 'return { ["Look at it"] = "Sehen Sie hin", ["Touch"] = "Tasten" }' >"$work/mine/curriculum.de.lua"
expect 0 "" "$rhexis" check "$work/mine"
says 'no text in fr: "Touch"'
! grep -q "no text in de" "$work/stdout" || fail "de is complete"
expect 0 "" "$rhexis" run "$work/mine" --surgeon none --language de "${short[@]}" --out "$work/de"
report_has de '"title": "Sehen Sie hin"'
echo 'return { 7 }' >"$work/mine/curriculum.de.lua"
expect 1 "mine/curriculum.de.lua: texts must be pairs" "$rhexis" check "$work/mine"

# Level, mode, eye and hand.
expect 0 "" "$work/run" C hard --level hard --eye left --hand left
report_has hard '"level": "hard"'
report_has hard '"mode": "exam"'
report_has hard '"hints": false'
report_has hard '"side": "left"'
report_has hard '"pupil_mm": 6'
report_has hard '"handedness": "left"'
expect 0 "" "$rhexis" replay "$work/hard" --verify
expect 0 "" "$work/run" C taught --level hard --mode teaching --set patient.pupil_mm=7
report_has taught '"hints": true'
report_has taught '"pupil_mm": 7'
expect 2 "--level hrad: the exercise has no level 'hrad' (did you mean hard?)" "$work/run" C wrong --level hrad
expect 2 "--mode: eaxm not in {teaching,exam}" "$work/run" C wrong --mode eaxm
finished
