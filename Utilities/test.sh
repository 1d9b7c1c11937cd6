#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
#
# test.sh [PRESET [CTEST OPTION...]]: builds vtkOIT with its tests into build/ and runs them all.
# PRESET as in setup.sh; the options go to ctest: `test.sh release -L unit` runs the unit tests.
set -eu
# shellcheck source=common.sh
. "$(dirname -- "$0")/common.sh"
preset=${1:-release}
[ $# = 0 ] || shift

"$root/Utilities/packages.sh"

say "building in $root/build"
cd "$root"
quietly build/configure.log cmake --preset "$preset" -DBUILD_TESTING=ON
cmake --build build

say "running the tests"
ctest --test-dir build --output-on-failure --no-tests=error --parallel "$(nproc)" "$@"
