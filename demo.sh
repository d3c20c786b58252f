#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# On a fresh Debian 12: installs what is missing, builds, and lets the virtual expert sculpt a groove into a cataract.
set -euo pipefail
. "$(dirname "$0")/scripts/dev/steps.sh"

case "${1:-}" in
-h | --help)
    say "usage: ./demo.sh [OUTPUT_FOLDER]     (default: runs/groove-demo)"
    say "Sets this machine up (deps.txt), builds rhexis and runs the exercise 'groove' by the expert surgeon."
    say "The first run takes some minutes, a second one seconds."
    exit 0
    ;;
esac
out=${1:-$repository/runs/groove-demo}

step 1 3 "packages"
install_packages
step 2 3 "building (the first time this takes some minutes)"
build release Release rhexis
binary="$repository/build/release/bindings/cli/rhexis"
step 3 3 "a groove, by the virtual expert, seed 1"
if [ -f "$out/report.html" ] &&
    [ -z "$(find "$binary" "$repository/curricula" "$repository/scripts" -newer "$out/report.html" -print -quit)" ]; then
    say "      nothing has changed since the last run, so this is what it gave (remove $out to run it again):"
    say "  report     $out/report.html"
    say "  pictures   $out/frames/"
    say "  video      $out/video.mp4"
    say "  recording  $out/recording.rhx"
else
    mkdir -p "$(dirname "$out")"
    "$binary" run groove --surgeon expert --seed 1 --video --out "$out"
fi
say "done in $(elapsed)"
