#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
#
# test.sh [PRESET [--long] [CTEST OPTION...]]: builds vtkOIT with its tests into build/ and runs
# them, but for those of the label long, which .ci/run runs too; with --long these as well. PRESET
# as in setup.sh; the options go to ctest: `test.sh release -L unit` runs the unit tests,
# `test.sh release --long -L long` the long ones.
set -eu
# shellcheck source=common.sh
. "$(dirname -- "$0")/common.sh"
preset=${1:-release}
[ $# = 0 ] || shift
if [ "${1:-}" = --long ]; then
  shift
  which="running the tests"
else
  set -- --label-exclude '^long$' "$@"
  which="running the tests, without those of the label long (test.sh $preset --long has them too)"
fi

"$root/Utilities/packages.sh" tests

say "building in $root/build"
cd "$root"
quietly build/configure.log cmake --preset "$preset" -DBUILD_TESTING=ON
cmake --build build

say "$which"
ctest --test-dir build --output-on-failure --no-tests=error --parallel "$(nproc)" "$@"
