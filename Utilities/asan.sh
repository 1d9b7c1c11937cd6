#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
#
# asan.sh [CTEST OPTION...]: builds the C++ modules and tests with AddressSanitizer into
# build-asan/ and runs them, without those of the label long. A leak or a wrong access fails; what
# leaks inside other projects' libraries is listed in sanitizers/lsan.supp.
set -eu
# shellcheck source=common.sh
. "$(dirname -- "$0")/common.sh"

"$root/Utilities/packages.sh"

say "building with AddressSanitizer in $root/build-asan"
cd "$root"
quietly build-asan/configure.log cmake --preset asan
cmake --build build-asan

say "running the tests under AddressSanitizer, without those of the label long"
export ASAN_OPTIONS="strict_string_checks=1:detect_stack_use_after_return=1"
export LSAN_OPTIONS="suppressions=$root/Utilities/sanitizers/lsan.supp:print_suppressions=0"
ctest --test-dir build-asan --output-on-failure --no-tests=error --parallel "$(nproc)" \
  --label-exclude '^long$' "$@"
