#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
#
# packages.sh: installs the Debian packages that building needs, those that are missing.
# packages.sh --tests: those of the tests, too, among them a browser.
# packages.sh --list: prints the names of all. A name that ends in ? is left out where the release
# does not have it (Mesa dropped OSMesa; there the EGL libraries serve).
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

case ${1:-} in
  '')
    # shellcheck disable=SC2086 # a list of package names
    install_packages $packages
    ;;
  --tests)
    # shellcheck disable=SC2086
    install_packages $packages $test_packages
    ;;
  --list)
    # shellcheck disable=SC2086
    printf '%s\n' $packages $test_packages
    ;;
  *)
    fail "unknown argument $1; usage: packages.sh [--tests | --list]" 2
    ;;
esac
