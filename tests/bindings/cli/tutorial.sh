#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# docs/tutorial.md, done word by word: its files are written, its commands run, its outputs compared. In the page,
# "File `NAME`:" goes before the text of a file, ```sh are commands, and each line of the ```output that follows must
# stand in what they said, from its beginning on.
set -u
. "$(dirname "$0")/expect.sh"
page=${2:-$PWD/docs/tutorial.md}
home=$PWD
cd "$work" || exit 2
mkdir -p build/release/bindings
ln -s "$(dirname "$rhexis")" build/release/bindings/cli
export RHEXIS_HOME=$home

# blocks/NN.KIND: the page in its order; a file's name on the first line of NN.file.
mkdir blocks
awk '
/^File `[^`]+`:$/ { split($0, parts, "`"); name = parts[2]; next }
/^```[a-z]+$/ && !inside { inside = 1; kind = substr($0, 4)
    if (name != "") kind = "file"
    out = sprintf("blocks/%03d.%s", ++count, kind)
    if (name != "") print name > out
    else printf "" > out
    name = ""; next }
/^```$/ && inside { inside = 0; close(out); next }
inside { print > out }' "$page"

files=0 commands=0 outputs=0
: >said
for block in blocks/*; do
    case $block in
        *.file)
            file=$(head -n 1 "$block")
            mkdir -p "$(dirname "$file")"
            tail -n +2 "$block" >"$file"
            files=$((files + 1))
            ;;
        *.sh)
            commands=$((commands + $(grep -c . "$block")))
            { cat "$block"; echo; echo "export -p >environment"; } >step
            # an environment that goes on, as in one terminal; a command that fails ends the tutorial
            [ ! -e environment ] || . ./environment
            bash -e step >said 2>&1 || fail "$block: $(cat "$block"): $(tail -n 3 said)"
            ;;
        *.output)
            while IFS= read -r line; do
                outputs=$((outputs + 1))
                awk -v want="$line" 'index($0, want) == 1 { found = 1 } END { exit !found }' said ||
                    fail "the output lacks '$line': $(head -c 1500 said)"
            done <"$block"
            ;;
        *) fail "$block: a block that is no file, sh or output" ;;
    esac
done
[ "$files" -ge 4 ] && [ "$commands" -ge 10 ] && [ "$outputs" -ge 10 ] ||
    fail "only $files files, $commands commands, $outputs lines of output were found in $page"
[ -s runs/first/report.html ] || fail "no report"
grep -q '"level": "hard"' runs/exam/report.json || fail "the exam is not at its level"
grep -q '"mode": "exam"' runs/exam/report.json || fail "the exam is none"
grep -q '"side": "left"' runs/exam/report.json || fail "not the left eye"
finished
