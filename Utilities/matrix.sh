#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
#
# matrix.sh [--copy FILE TO] [--paraview] RELEASE [COMMAND...]: runs the command, default
# `Utilities/test.sh ci`, on a copy of this tree inside a bare Debian RELEASE (bookworm, trixie,
# testing, ...). --copy then copies a FILE of that tree out, to the file TO. --paraview takes another
# one, with ParaView, whose packages exclude those of VTK in Debian 12; default command there
# `Utilities/paraview.sh --here`. RELEASE all: bookworm, trixie and testing, one after the other,
# whatever fails; a line for each at the end.
#
# The root file system of the release is made once, by mmdebstrap, and kept with its packages and
# its build folder in ${XDG_CACHE_HOME:-$HOME/.cache}/vtkoit (VTKOIT_ROOTFS_CACHE names another
# folder). Delete it there to start afresh.
#
# Status: that of the command, of all the first one that is not 0; 77 with one line when the root file
# system cannot be made or entered.
set -eu
# shellcheck source=common.sh
. "$(dirname -- "$0")/common.sh"

wanted=
if [ "${1:-}" = --copy ] && [ $# -gt 3 ]; then
  wanted=$2
  target=$3
  shift 3
fi
packages=
paraview=
if [ "${1:-}" = --paraview ]; then
  packages=paraview
  paraview=-paraview
  shift
fi
case ${1:--} in
  -*) fail "usage: matrix.sh [--copy FILE TO] [--paraview] RELEASE [COMMAND...], such as: matrix.sh testing" 2 ;;
esac
if [ "$1" = all ]; then
  shift
  status=0
  lines=
  for release in bookworm trixie testing; do
    result=0
    "$0" ${paraview:+--paraview} "$release" "$@" || result=$?
    lines="$lines Debian $release: status $result;"
    [ "$status" != 0 ] || status=$result
  done
  say "${lines# }"
  exit "$status"
fi
release=$1
# shellcheck source=rootfs.sh
. "$(dirname -- "$0")/rootfs.sh"

unavailable()
{
  fail "Debian $release is not tested here: $*" 77
}

if [ "$(id -u)" != 0 ]; then
  command -v sudo >/dev/null 2>&1 || unavailable "chroot needs root, and there is no sudo"
  [ -t 0 ] || sudo -n true 2>/dev/null || unavailable "chroot needs root, and sudo a password"
  exec sudo -- env VTKOIT_ROOTFS_CACHE="$cache" "$0" \
    ${wanted:+--copy "$wanted" "$target"} ${paraview:+--paraview} "$@"
fi
shift
if [ $# = 0 ] && [ -n "$paraview" ]; then
  set -- Utilities/paraview.sh --here
elif [ $# = 0 ]; then
  set -- Utilities/test.sh ci
fi

check_rootfs
name=debian-$release$paraview-$(dpkg --print-architecture)
rootfs=$cache/$name
exec 9>"$cache/$name.lock"
flock 9

copy_source()
{
  mkdir -p "$1/vtkoit"
  find "$1/vtkoit" -mindepth 1 -maxdepth 1 ! -name 'build*' -exec rm -rf {} +
  tar -C "$root" --exclude='./build*' --exclude=./.git -cf - . | tar -C "$1/vtkoit" -xf - ||
    unavailable "cannot write to $1"
  # The network of the machine that runs this, not of the one that the tree was made on.
  cp -L /etc/resolv.conf "$1/etc/resolv.conf" 2>/dev/null || :
}

if [ ! -d "$rootfs" ]; then
  make_rootfs "$rootfs"
else
  say "using the root file system in $rootfs"
fi
copy_source "$rootfs"
# shellcheck disable=SC2086 # nothing, or the name of a group
inside "$rootfs" /vtkoit Utilities/packages.sh $packages ||
  unavailable "packages could not be installed in $rootfs (delete it to start afresh)"

say "in Debian $release: $*"
inside "$rootfs" /vtkoit "$@"

if [ -n "$wanted" ]; then
  cp "$rootfs/vtkoit/$wanted" "$target"
  [ -z "${SUDO_UID:-}" ] || chown "$SUDO_UID:${SUDO_GID:-}" "$target"
fi
