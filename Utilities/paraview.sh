#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
#
# paraview.sh [RELEASE]: builds the plugin for ParaView and runs its tests in a bare root file system
# of a Debian RELEASE (default: bookworm), which gets ParaView: see matrix.sh.
# paraview.sh --here [--no-tests]: does so on this system, into build-paraview/. In Debian 12 the
# packages of ParaView and those of the system's VTK exclude each other.
set -eu
# shellcheck source=common.sh
. "$(dirname -- "$0")/common.sh"

if [ "${1:-}" != --here ]; then
  case ${1:-} in
    -*) fail "usage: paraview.sh [RELEASE | --here [--no-tests]]" 2 ;;
  esac
  exec "$root/Utilities/matrix.sh" --paraview "${1:-bookworm}" Utilities/paraview.sh --here
fi

"$root/Utilities/packages.sh" paraview
say "building in $root/build-paraview"
cd "$root"
quietly build-paraview/configure.log cmake --preset paraview
cmake --build --preset paraview
[ "${2:-}" != --no-tests ] || exit 0
say "running the tests"
ctest --preset paraview --no-tests=error
