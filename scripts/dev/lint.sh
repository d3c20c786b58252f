#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# lint.sh [tidy]: clang-format and luacheck over the tree; with `tidy` also clang-tidy (slow).
set -uo pipefail
cd "$(dirname "$0")/../.." || exit 2
status=0

mapfile -t cpp < <(git ls-files -co --exclude-standard '*.cpp' '*.hpp')
if [ "${#cpp[@]}" -eq 0 ]; then
    echo "rhexis: git lists no source files here, so there is nothing to check" >&2
    exit 2
fi
if ! clang-format --dry-run -Werror "${cpp[@]}" 2>/tmp/rhexis-format.$$; then
    grep -m 20 'error:' /tmp/rhexis-format.$$
    status=1
fi
rm -f /tmp/rhexis-format.$$

mapfile -t lua < <(git ls-files -co --exclude-standard '*.lua')
if ! luacheck -q --no-color "${lua[@]}" | tail -n 30; then
    status=1
fi

if [ "${1:-}" = tidy ]; then
    # without the loops for instruction sets, which only gcc reads; a folder of its own, never built: clang cannot read
    # the precompiled headers of another compiler, and reads one source at a time
    cmake -S . -B build/tidy -G Ninja -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DCMAKE_UNITY_BUILD=OFF >/dev/null || exit 2
    mapfile -t sources < <(git ls-files 'kernel/*.cpp' 'bindings/*.cpp' ':!*_kernel_*.cpp')
    printf '%s\n' "${sources[@]}" | xargs -P "$(nproc)" -n 4 clang-tidy -p build/tidy --quiet 2>/dev/null || status=1
fi
exit $status
