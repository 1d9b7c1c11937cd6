#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Instructions of the first picture of a process and of a steady frame, as multiples of those of unsorted
# blending: a measure that other work on the machine does not touch.
#
#   Utilities/instructions.sh [BUILD]            prints them
#   Utilities/instructions.sh [BUILD] --check    fails when one has grown by more than 2 %
#   Utilities/instructions.sh [BUILD] --record   takes them for what --check compares with
#
# --scenes and --methods count others; a scene by a method takes 40 seconds of a core, all of them 8 minutes.
# Needs valgrind.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
build="$here/../build"
if [ $# -gt 0 ] && [ "${1#-}" = "$1" ]; then
  build="$1"
  shift
fi
exec "${PYTHON:-/usr/bin/python3}" "$here/compare_builds.py" instructions "$build" "$@"
