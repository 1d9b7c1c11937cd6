#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
#
# packages.sh: installs the Debian packages that building and testing need, those that are missing.
# packages.sh applications: those too that the tests with programs of the distribution need; without
# them such a test is skipped.
# packages.sh --list [applications]: prints their names. A name that ends in ? is left out where the release does
# not have it (Mesa dropped OSMesa; there the EGL libraries serve).
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
'

applications='
  f3d?
  mayavi2?
  python3-pyvista?
  python3-vedo?
  xvfb
'

list=
if [ "${1:-}" = --list ]; then
  list=yes
  shift
fi
case ${1:-} in
  '') ;;
  applications) packages="$packages $applications" ;;
  *) fail "unknown argument $1; usage: packages.sh [--list] [applications]" 2 ;;
esac
if [ -n "$list" ]; then
  # shellcheck disable=SC2086 # a list of package names
  printf '%s\n' $packages
else
  # shellcheck disable=SC2086
  install_packages $packages
fi
