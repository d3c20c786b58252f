#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# On a fresh Debian 12: installs what is missing, checks style, builds twice (Release; under sanitizers) and runs every test.
set -euo pipefail
. "$(dirname "$0")/scripts/dev/steps.sh"

case "${1:-}" in
-h | --help)
    say "usage: ./test.sh [quick | long]"
    say "quick: Release build and quick tests only. long: also whole exercises by virtual surgeons (an hour or more)."
    exit 0
    ;;
esac
quick=${1:-}
jobs=$(nproc)
failed=0

# BLAS begins a thread per core, which nothing here uses, and while a program begins they turn round and round.
export OPENBLAS_NUM_THREADS=1

run_tests() {  # FOLDER CTEST_ARGUMENTS...
    local folder=$1
    shift
    (cd "$repository/build/$folder" && ctest -j "$jobs" --output-on-failure --timeout 900 "$@") || failed=1
}

if [ "$quick" = quick ]; then
    step 1 3 "packages"
    install_packages
    step 2 3 "building Release"
    build release Release
    step 3 3 "quick tests"
    run_tests release -LE 'slow|long'
else
    step 1 6 "packages"
    install_packages
    step 2 6 "style: clang-format, luacheck"
    "$repository/scripts/dev/lint.sh" || failed=1
    step 3 6 "building Release"
    build release Release
    step 4 6 "building under Address and UndefinedBehavior sanitizers"
    build sanitize Sanitize
    step 5 6 "all tests, Release ($(elapsed) so far)"
    if [ "$quick" = long ]; then run_tests release; else run_tests release -LE long; fi
    step 6 6 "quick tests, sanitized ($(elapsed) so far)"
    run_tests sanitize -LE 'slow|long'
fi
say "finished in $(elapsed)"
exit $failed
