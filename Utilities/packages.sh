#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
#
# packages.sh [tests] [applications]: installs the Debian packages that are missing: those that
# building needs, those of the tests (among them a browser), and programs of the distribution that
# some tests draw with. A test that misses something is skipped.
# packages.sh paraview: those that the plugin for ParaView needs, and its tests, instead. In Debian 12
# ParaView has a VTK of its own, whose packages exclude those of the system's.
# packages.sh --list [tests] [applications] [paraview]: prints their names. A name that ends in ? is
# left out where the release does not have it (Mesa dropped OSMesa; there the EGL libraries serve).
set -eu
# shellcheck source=common.sh
. "$(dirname -- "$0")/common.sh"

packages='
  ca-certificates
  cmake
  g++
  ninja-build
  libvtk9-dev
  python3-vtk9
  python3-matplotlib
  python3-numpy
  libglm-dev
  libosmesa6?
  libegl1
  libgl1-mesa-dri
  glslang-tools?
  help2man
  python3-shtab
'

test_packages='
  chromium?
  chromium-driver?
  mypy?
  python3-selenium?
'

applications='
  f3d?
  mayavi2?
  python3-pyvista?
  python3-vedo?
  xvfb
'

# From libdouble-conversion-dev on: paraview-dev needs their files and does not depend on them.
paraview='
  ca-certificates
  cmake
  g++
  ninja-build
  libglm-dev
  libgl1-mesa-dri
  libosmesa6?
  libegl1
  mpi-default-bin
  paraview
  paraview-dev
  python3-numpy
  python3-paraview
  xvfb
  libqt5svg5?
  libdouble-conversion-dev
  libexpat1-dev
  libfreetype-dev
  libgl-dev
  libglew-dev
  libjpeg-dev
  liblz4-dev
  liblzma-dev
  libpng-dev
  libtiff-dev
  libx11-dev
  libxcursor-dev
  libxext-dev
  libxt-dev
  mpi-default-dev
  python3-dev
  zlib1g-dev
'

# draws_by_system: whether ParaView's packages are for the system's VTK, as from Debian testing on, and
# not for one of its own. Their paraview-dev needs libvtk9-dev and does not depend on it.
draws_by_system()
{
  apt-cache depends paraview 2>/dev/null | grep -q 'Depends: libvtk9'
}

list=
if [ "${1:-}" = --list ]; then
  list=yes
  shift
fi
for group in "$@"; do
  case $group in
    tests) packages="$packages $test_packages" ;;
    applications) packages="$packages $applications" ;;
    paraview) packages=$paraview ;;
    *) fail "unknown argument $group; usage: packages.sh [--list] [tests] [applications] | paraview" 2 ;;
  esac
done
if [ -n "$list" ]; then
  # shellcheck disable=SC2086 # a list of package names
  printf '%s\n' $packages
else
  # shellcheck disable=SC2086
  install_packages $packages
  if [ "$packages" = "$paraview" ] && draws_by_system; then
    install_packages libvtk9-dev
  fi
fi
