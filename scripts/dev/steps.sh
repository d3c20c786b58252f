# SPDX-License-Identifier: GPL-3.0-or-later
# Shared by demo.sh and test.sh: say what is being done and how long is left; install packages; build.
# shellcheck shell=bash

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
started=$(date +%s)

say() { printf '%s\n' "$*"; }

# step N TOTAL TEXT
step() { say "[$1/$2] $3"; }

elapsed() {
    local seconds=$(($(date +%s) - started))
    printf '%d min %02d s' $((seconds / 60)) $((seconds % 60))
}

packages() { sed 's/#.*//' "$repository/deps.txt" | awk 'NF { print $1 }'; }

missing_packages() {
    local name
    for name in $(packages); do
        dpkg-query -W -f '${db:Status-Status}' "$name" 2>/dev/null | grep -qx installed || echo "$name"
    done
}

# Installs what deps.txt lists and this machine lacks.
install_packages() {
    local missing
    mapfile -t missing < <(missing_packages)
    if [ "${#missing[@]}" -eq 0 ]; then
        say "      all $(packages | wc -l) packages are there"
        return
    fi
    if ! command -v apt-get >/dev/null; then
        say "rhexis: this machine has no apt-get; please install what corresponds to: ${missing[*]}" >&2
        exit 2
    fi
    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        as_root=(sudo)
    fi
    say "      installing ${#missing[@]} packages: ${missing[*]}"
    local log
    log=$(mktemp)
    if ! { "${as_root[@]}" apt-get update &&
        "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"; } >"$log" 2>&1; then
        tail -n 20 "$log" >&2
        say "rhexis: the packages could not be installed (apt-get's last lines above)" >&2
        exit 2
    fi
    rm -f "$log"
}

# Turns ninja's "[n/total] ..." lines into one progress line with the time left (on a terminal) or one line in ten per
# cent (in a pipe); compiler messages pass through.
progress() {
    awk -v tty="$([ -t 1 ] && echo 1 || echo 0)" '
        BEGIN { start = systime() }
        match($0, /^\[[0-9]+\/[0-9]+\]/) {
            split(substr($0, 2, RLENGTH - 2), n, "/")
            spent = systime() - start
            left = n[1] > 4 ? int(spent * (n[2] - n[1]) / n[1]) : -1
            text = sprintf("      %d of %d%s", n[1], n[2], left < 0 ? "" : sprintf(", about %d min %02d s left", left / 60, left % 60))
            tenth = int(10 * n[1] / n[2])
            if (tty) printf "\r%-60s", text
            else if (tenth != last) { print text; last = tenth }
            fflush()
            next
        }
        /^ninja: (no work|Entering)/ { next }
        { if (tty) printf "\n"; print; fflush() }
        END { if (tty && n[2]) printf "\r%60s\r", "" }'
}

# build FOLDER BUILD_TYPE [TARGET...]
build() {
    local folder="$repository/build/$1" type=$2
    shift 2
    local log compiler=${CXX:-g++}
    # What sanitizers put in takes g++ nearly twice as long to compile.
    if [ "$type" = Sanitize ] && command -v clang++ >/dev/null; then compiler=clang++; fi
    log=$(mktemp)
    if ! CXX=$compiler cmake -S "$repository" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE="$type" >"$log" 2>&1; then
        cat "$log" >&2
        say "rhexis: cmake could not configure $folder" >&2
        exit 2
    fi
    rm -f "$log"
    set -o pipefail
    if ! ninja -C "$folder" "$@" | progress; then
        say "rhexis: the build in $folder failed" >&2
        exit 1
    fi
}

need_gnuplot() {
    if ! command -v gnuplot >/dev/null; then
        say "rhexis: the chart needs gnuplot (apt-get install gnuplot-nox)" >&2
        exit 2
    fi
}

# bench_to_csv CASE FILE FIELD...: measures, and keeps these fields of the rows.
bench_to_csv() {
    local case=$1 file=$2
    shift 2
    say "measuring (some minutes)"
    "$repository/build/release/bindings/cli/rhexis" bench "$case" --json >"$file.json"
    python3 "$repository/scripts/dev/bench_to_csv.py" "$file.json" "$@" >"$file"
    rm "$file.json"
}
