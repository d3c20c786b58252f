#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The report as a browser without a window shows and prints it, in French. Skipped (77) where no Chromium is there or it
# cannot even print an empty page.
set -u
. "$(dirname "$0")/expect.sh"
browser=""
for name in chromium chromium-browser google-chrome; do
  command -v "$name" >/dev/null && browser=$name && break
done
if [ -z "$browser" ] || ! command -v pdftotext >/dev/null; then
  echo "skipped: it needs chromium and pdftotext"
  exit 77
fi
shown() { HOME="$work" timeout 120 "$browser" --headless --no-sandbox --disable-gpu "$@" >"$work/shown" 2>"$work/errors"; }
if ! shown --print-to-pdf="$work/empty.pdf" about:blank; then
  echo "skipped: $browser does not run here: $(tail -n 1 "$work/errors")"
  exit 77
fi
export RHEXIS_RECORDS="$work/records.db"
run=("$rhexis" run incision --surgeon b --language fr)
expect 0 "" "${run[@]}" --seed 101 --trainee P07 --cohort G --no-pictures --out "$work/first"
expect 0 "" "${run[@]}" --seed 102 --trainee P07 --cohort G --out "$work/second"

shown --no-pdf-header-footer --print-to-pdf="$work/page.pdf" "file://$work/second/report.html" ||
  fail "the report was not printed: $(tail -n 1 "$work/errors")"
pdftotext -layout "$work/page.pdf" "$work/text"
printed() { grep -qF -- "$1" "$work/text" || fail "the printed report lacks $1"; }
# title, score, ground of a threshold, comparison, time line, charts, ways, and what stands below every page
for text in "Incision et contre-incision" "Note, critère par critère" "proposition" "Essai 2." "Déroulement" "Images" \
  "Pression dans l'œil" "Spectre du tremblement" "Trajet de l'instrument : kératome" "non validé cliniquement" \
  "Ces notes n'ont pas été validées cliniquement."; do
  printed "$text"
done
pages=$(grep -c "non validé cliniquement" "$work/text")
[ "$pages" -ge 3 ] || fail "only $pages pages say that scores are not validated"
# Every picture that the page holds is there, on paper too.
held=$(grep -o '<img ' "$work/second/report.html" | wc -l)
drawn=$(pdfimages -list "$work/page.pdf" | grep -c ' image ')
[ "$held" -ge 4 ] || fail "the page holds $held pictures"
[ "$drawn" -ge "$held" ] || fail "$drawn of $held pictures are printed"
# The page reaches for nothing outside of itself.
! grep -qE 'https?://' "$work/second/report.html" || fail "the page reaches for the network"

shown --dump-dom "file://$work/second/report.html" || fail "the report was not shown"
for element in "<svg" "<table" "<figure"; do
  grep -qF -- "$element" "$work/shown" || fail "the page shows no $element"
done
finished
