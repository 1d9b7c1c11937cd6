#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
#
# matrix.sh [--copy FILE TO] RELEASE [COMMAND...]: runs the command, default `Utilities/test.sh ci`,
# on a copy of this tree inside a bare Debian RELEASE (bookworm, trixie, testing, ...). --copy then
# copies a FILE of that tree out, to the file TO.
#
# The root file system of the release is made once, by mmdebstrap, and kept with its packages and
# its build folder in ${XDG_CACHE_HOME:-$HOME/.cache}/vtkoit (VTKOIT_ROOTFS_CACHE names another
# folder). Delete it there to start afresh.
#
# Status: that of the command; 77 with one line when the root file system cannot be made or entered.
set -eu
# shellcheck source=common.sh
. "$(dirname -- "$0")/common.sh"

wanted=
if [ "${1:-}" = --copy ] && [ $# -gt 3 ]; then
  wanted=$2
  target=$3
  shift 3
fi
case ${1:--} in
  -*) fail "usage: matrix.sh [--copy FILE TO] RELEASE [COMMAND...], such as: matrix.sh testing" 2 ;;
esac
release=$1
cache=${VTKOIT_ROOTFS_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/vtkoit}

unavailable()
{
  fail "Debian $release is not tested here: $*" 77
}

if [ "$(id -u)" != 0 ]; then
  command -v sudo >/dev/null 2>&1 || unavailable "chroot needs root, and there is no sudo"
  [ -t 0 ] || sudo -n true 2>/dev/null || unavailable "chroot needs root, and sudo a password"
  exec sudo -- env VTKOIT_ROOTFS_CACHE="$cache" "$0" \
    ${wanted:+--copy "$wanted" "$target"} "$@"
fi
shift
[ $# -gt 0 ] || set -- Utilities/test.sh ci

command -v dpkg >/dev/null 2>&1 || unavailable "this is no Debian system"
unshare --mount --pid --fork true 2>/dev/null || unavailable "no right to mount in this container"
name=debian-$release-$(dpkg --print-architecture)
rootfs=$cache/$name
mkdir -p "$cache"
exec 9>"$cache/$name.lock"
flock 9

# inside ROOTFS COMMAND...: in the copy of the tree, with /proc and /dev that vanish with it.
inside()
{
  tree=$1
  shift
  unshare --mount --pid --fork --kill-child sh -euc '
    mount -t proc proc "$1/proc"
    mount --rbind /dev "$1/dev"
    tree=$1
    shift
    exec env -i HOME=/root LANG=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin \
      chroot "$tree" sh -c "cd /vtkoit && exec \"\$@\"" sh "$@"' sh "$tree" "$@"
}

copy_source()
{
  mkdir -p "$1/vtkoit"
  find "$1/vtkoit" -mindepth 1 -maxdepth 1 ! -name 'build*' -exec rm -rf {} +
  tar -C "$root" --exclude='./build*' --exclude=./.git -cf - . | tar -C "$1/vtkoit" -xf - ||
    unavailable "cannot write to $1"
  # The network of the machine that runs this, not of the one that the tree was made on.
  cp -L /etc/resolv.conf "$1/etc/resolv.conf" 2>/dev/null || :
}

make_rootfs()
{
  (install_packages mmdebstrap debian-archive-keyring) || unavailable "no mmdebstrap"
  rm -rf --one-file-system "$rootfs.part"
  # The mirror that this machine uses; without one, mmdebstrap knows Debian's own.
  mirror=$(apt-get indextargets --format '$(REPO_URI)' | grep -m 1 '/debian/*$' || :)
  say "making a root file system of Debian $release in $rootfs"
  # shellcheck disable=SC2086 # one mirror or none
  mmdebstrap --quiet --mode=root --variant=minbase \
    --aptopt='Acquire::Check-Valid-Until "false"' --dpkgopt=force-unsafe-io \
    "$release" "$rootfs.part" $mirror || {
    rm -rf --one-file-system "$rootfs.part"
    unavailable "mmdebstrap failed (mirror or network)"
  }
  mv "$rootfs.part" "$rootfs"
}

if [ ! -d "$rootfs" ]; then
  make_rootfs
else
  say "using the root file system in $rootfs"
fi
copy_source "$rootfs"
inside "$rootfs" Utilities/packages.sh ||
  unavailable "packages could not be installed in $rootfs (delete it to start afresh)"

say "in Debian $release: $*"
inside "$rootfs" "$@"

if [ -n "$wanted" ]; then
  cp "$rootfs/vtkoit/$wanted" "$target"
  [ -z "${SUDO_UID:-}" ] || chown "$SUDO_UID:${SUDO_GID:-}" "$target"
fi
