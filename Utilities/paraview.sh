#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
#
# paraview.sh [RELEASE]: builds the plugin for ParaView, runs its tests, makes its package, installs,
# uses and purges it in a bare root file system of a Debian RELEASE (default: bookworm), which gets
# ParaView: see matrix.sh.
# paraview.sh --here: builds into build-paraview/ and runs the tests on this system. In Debian 12 the
# packages of ParaView and those of the system's VTK exclude each other.
# paraview.sh --here --package: makes the package and tries it on this system, as root.
set -eu
# shellcheck source=common.sh
. "$(dirname -- "$0")/common.sh"

build()
{
  "$root/Utilities/packages.sh" paraview
  say "building in $root/build-paraview"
  quietly build-paraview/configure.log cmake --preset paraview
  cmake --build --preset paraview
}

# The plugin draws a square of opacity 0.5 in front of another one, from a folder without vtkOIT.
try_package()
{
  install_packages dpkg-dev file gzip lintian
  rm -rf build-paraview/packages
  quietly build-paraview/cpack.log cpack --preset paraview
  lintian --fail-on error --tag-display-limit 0 build-paraview/packages/*.deb \
    2>build-paraview/lintian.log || fail "lintian found the errors above"
  say "installing, using and purging paraview-vtkoit"
  as_root dpkg --install build-paraview/packages/*.deb >build-paraview/dpkg.log
  status=0
  python3 Testing/ParaView/on_screen.py paraview-vtkoit pvpython --dr \
    Testing/ParaView/UsePackage.py || status=$?
  as_root dpkg --purge paraview-vtkoit >>build-paraview/dpkg.log
  [ "$status" = 0 ] || fail "the installed plugin does not draw" "$status"
  left=$(find /usr /etc /var/lib -ipath '*vtkoit*' ! -path '/var/lib/dpkg/*' ! -path "$root/*")
  [ -z "$left" ] || fail "left by purge: $left"
}

cd "$root"
mkdir -p "$MESA_SHADER_CACHE_DIR"
case "${1:-} ${2:-}" in
  '--here ')
    build
    say "running the tests"
    ctest --preset paraview --no-tests=error
    ;;
  '--here --package')
    build
    try_package
    ;;
  -*) fail "usage: paraview.sh [RELEASE | --here [--package]]" 2 ;;
  *)
    exec "$root/Utilities/matrix.sh" --paraview "${1:-bookworm}" \
      sh -c 'Utilities/paraview.sh --here && Utilities/paraview.sh --here --package'
    ;;
esac
