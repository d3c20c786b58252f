#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The same exercise in 12 processes for each way to advance, with one and two threads and every instruction set that the
# machine has, while its scripts walk tables: one hash for each way. Another seed, and another order of the walk, give
# others.
set -u
. "$(dirname "$0")/expect.sh"
walk=$(dirname "$0")/walk
sets=(baseline)
for name in avx2 avx512f; do
    grep -qw "$name" /proc/cpuinfo && sets+=("${name%f}")
done

# attempt FOLDER ARGUMENT...: runs the exercise and puts the hash of its end into $hash.
attempt() {
    local folder=$work/$1
    shift
    expect 0 "" "$rhexis" run "$walk" --surgeon expert --limit 0.4 --no-pictures --out "$folder" "$@"
    hash=$(sed -n 's/.*"state_hash": "\([0-9a-f]*\)".*/\1/p' "$folder/report.json")
    [ -n "$hash" ] || fail "no state hash: $*"
}

processes=12
for way in explicit implicit; do
    first=""
    for ((i = 0; i < processes; ++i)); do
        threads=$((i % 2 + 1))
        set=${sets[$((i / 2 % ${#sets[@]}))]}
        attempt "$way" --set advance="$way" --threads $threads --instruction-set "$set"
        first=${first:-$hash}
        [ "$hash" = "$first" ] || fail "$way, $threads threads, $set: $hash instead of $first"
    done
    echo "$way: $processes processes, ${sets[*]}, 1 and 2 threads: $first"
    expect 0 "" "$rhexis" replay "$work/$way" --verify --instruction-set baseline --threads 2
    says "identical"
    attempt other --set advance="$way" --seed 2
    [ "$hash" != "$first" ] || fail "$way: another seed ends in the same state"
    attempt other --set advance="$way" --set goal.backwards=1
    [ "$hash" != "$first" ] || fail "$way: another order of the walk ends in the same state"
    hashes+=("$first")
done
[ "${hashes[0]}" != "${hashes[1]}" ] || fail "both ways to advance end in the same state"
finished
