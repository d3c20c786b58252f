#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# run.sh BUILD_DIR: installs the build into an empty folder, builds host.cpp against it, runs it.
set -euo pipefail
build=$(realpath "$1")
here=$(realpath "$(dirname "$0")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cmake --install "$build" --prefix "$work/installed" >"$work/install.log"
cmake -S "$here" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$work/installed" >"$work/configure.log"
cmake --build "$work/build" >"$work/build.log" || { cat "$work/build.log"; exit 1; }
"$work/build/host"

# Without one of the libraries that it needs, it is not there, which is no error to who can do without.
found() { # found ARGUMENTS...: what a program that asks quietly learns
    rm -rf "$work/asks"
    cmake -S "$here" -B "$work/asks" -G Ninja -DOPTIONAL=ON -DCMAKE_PREFIX_PATH="$work/installed" "$@" 2>&1 | sed -n 's/.*rhexis found: //p'
}
[ "$(found)" = 1 ]
[ "$(found -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON)" = 0 ]
[ "$(PKG_CONFIG_LIBDIR=/nonexistent found)" = 0 ]
