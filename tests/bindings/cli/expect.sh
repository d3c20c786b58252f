# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by the scripts beside it. $1 of the script is the program; $work is a folder of its own that goes at the end.
rhexis=$(realpath "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

fail() {
    echo "FAILED: $*"
    failures=$((failures + 1))
}

# expect STATUS TEXT COMMAND...: the command ends with that status within a minute and says TEXT on stderr in its only
# line there. An empty TEXT stands for silence.
expect() {
    local status=$1 text=$2 got=0
    shift 2
    timeout 60 "$@" >"$work/stdout" 2>"$work/stderr" || got=$?
    [ "$got" = "$status" ] || fail "status $got instead of $status: $* ($(head -c 300 "$work/stderr"))"
    if [ -z "$text" ]; then
        [ ! -s "$work/stderr" ] || fail "not silent: $* ($(head -c 300 "$work/stderr"))"
    else
        grep -qF -- "$text" "$work/stderr" || fail "no '$text': $* ($(head -c 300 "$work/stderr"))"
        [ "$(wc -l <"$work/stderr")" = 1 ] || fail "more than one line: $* ($(head -c 600 "$work/stderr"))"
    fi
}

# says TEXT: the last command said it on stdout.
says() { grep -qF -- "$1" "$work/stdout" || fail "stdout lacks '$1': $(head -c 300 "$work/stdout")"; }

# exercise NAME: a folder with a curriculum whose text is on stdin.
exercise() {
    mkdir -p "$work/$1"
    cat >"$work/$1/curriculum.lua"
    echo "$work/$1"
}

# limited BLOCKS COMMAND...: a limit on the size of files stands for a disk that fills up (the signal that comes with it
# is ignored).
limited() { (trap '' XFSZ; ulimit -f "$1"; shift; exec "$@"); }
export -f limited

# recorded FOLDER BYTES: waits until the recording there is longer.
recorded() {
    for _ in $(seq 600); do
        [ "$(stat -c %s "$1/recording.rhx.part" 2>/dev/null || echo 0)" -gt "$2" ] && break
        sleep 0.05
    done
}

# kill_when_recorded FOLDER PROCESS: in the middle, as soon as its recording there has some length.
kill_when_recorded() {
    recorded "$1" 100000
    kill -9 "$2"
    wait 2>/dev/null
}

finished() {
    [ "$failures" = 0 ] || exit 1
}
