#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The station's threads under the thread sanitizer, without OpenGL: usage: scripts/dev/threads.sh
# Builds build/thread, a few minutes the first time. Exit status: 0 they do not get into each other's way.
set -euo pipefail
. "$(dirname "$0")/steps.sh"
build thread Thread test_station
export TSAN_OPTIONS="halt_on_error=1 second_deadlock_stack=1"
export OPENBLAS_NUM_THREADS=1
cd "$repository" && build/thread/tests/bindings/station/test_station
