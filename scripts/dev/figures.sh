#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Measures the figures of README.md again: runs the commands of its table "Measured" one after another and keeps what each
# prints in build/figures/, beside the row that it is for. Needs a Release build (./demo.sh makes one) and a machine that
# does nothing else. All of them take some hours, most of it charts and the study.
#   usage: scripts/dev/figures.sh [--list] [--except REGEX] [REGEX]     which rows, by any text of theirs
set -euo pipefail
. "$(dirname "$0")/steps.sh"
cd "$repository"
kept=build/figures
PATH="$repository/build/release/bindings/cli:$PATH"

list=no except='^$' wanted=''
while [ $# -gt 0 ]; do
    case "$1" in
    -h | --help) sed -n '3,6s/^# *//p' "$0" && exit 0 ;;
    --list) list=yes ;;
    --except) except=${2:?--except needs a regular expression} && shift ;;
    -*) say "rhexis: there is no option $1 (--list, --except REGEX)" >&2 && exit 2 ;;
    *) wanted=$1 ;;
    esac
    shift
done

# Rows of the table: what, figure, command, apart by tabs.
rows() {
    awk -F' *\\| *' '/^## / { on = /Measured/ } on && NF == 5 && $4 ~ /`/ {
        gsub("`", "", $4); print $2 "\t" $3 "\t" $4 }' README.md | grep -E -- "$wanted" | grep -vE -- "$except"
}

if [ "$list" = no ] && ! command -v rhexis >/dev/null; then
    say "rhexis: there is no Release build (./demo.sh makes one)" >&2
    exit 2
fi
mapfile -t table < <(rows | awk -F'\t' '!seen[$3]++')  # a command that stands in two rows runs once
if [ "${#table[@]}" -eq 0 ]; then
    say "rhexis: no row of README.md's table \"Measured\" has: $wanted" >&2
    exit 2
fi
mkdir -p "$kept"
failed=0
for i in "${!table[@]}"; do
    IFS=$'\t' read -r what figure command <<<"${table[i]}"
    step $((i + 1)) ${#table[@]} "$command"
    if [ "$list" = yes ]; then continue; fi
    file="$kept/$(printf '%s' "$command" | tr -cs 'A-Za-z0-9' '_').txt"
    printf '%s\n%s\n$ %s\n' "$what" "$figure" "$command" >"$file"
    began=$(date +%s)
    eval "$command" >>"$file" 2>&1 || { say "      failed: $file" >&2 && failed=1; }
    say "      $(($(date +%s) - began)) s, $file"
done
exit $failed
