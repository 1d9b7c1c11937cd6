#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
#
# setup.sh [PRESET]: installs the distribution packages that are missing, builds vtkOIT into build/
# and renders the showcase into build/showcase/. PRESET is one of `cmake --list-presets` that
# builds into build/; default: release.
set -eu
# shellcheck source=common.sh
. "$(dirname -- "$0")/common.sh"
preset=${1:-release}

"$root/Utilities/packages.sh"

# The tests are left for test.sh, and stay where it has built them.
say "building in $root/build"
cd "$root"
testing=-DBUILD_TESTING=OFF
if [ -f build/CMakeCache.txt ]; then
  testing=
fi
# shellcheck disable=SC2086 # nothing, or one option
quietly build/configure.log cmake --preset "$preset" $testing
cmake --build build

say "rendering the showcase"
build/bin/vtkoit showcase --output build/showcase
say "done; all tests: ./Utilities/test.sh"
