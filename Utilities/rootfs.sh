# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=sh disable=SC2154 # $release
#
# Root file systems of Debian; sourced after common.sh by matrix.sh and packages_test.sh, which set
# $release and define unavailable MESSAGE, which does not return.

cache=${VTKOIT_ROOTFS_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/vtkoit}

# Ends the script where nothing can be mounted here.
check_rootfs()
{
  command -v dpkg >/dev/null 2>&1 || unavailable "this is no Debian system"
  unshare --mount --pid --fork true 2>/dev/null || unavailable "no right to mount in this container"
  mkdir -p "$cache"
}

# inside ROOTFS FOLDER COMMAND...: in a folder of it, with /proc and /dev that vanish with it.
inside()
{
  tree=$1
  shift
  unshare --mount --pid --fork --kill-child sh -euc '
    mount -t proc proc "$1/proc"
    mount --rbind /dev "$1/dev"
    tree=$1
    folder=$2
    shift 2
    exec env -i HOME=/root LANG=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin \
      chroot "$tree" sh -c "cd $folder && exec \"\$@\"" sh "$@"' sh "$tree" "$@"
}

# make_rootfs TARGET: a folder, or a file whose name ends in .tar.
make_rootfs()
{
  (install_packages mmdebstrap debian-archive-keyring) || unavailable "no mmdebstrap"
  case $1 in *.tar) part=${1%.tar}.part.tar ;; *) part=$1.part ;; esac
  rm -rf --one-file-system "$part"
  # The mirror that this machine uses; without one, mmdebstrap knows Debian's own.
  mirror=$(apt-get indextargets --format '$(REPO_URI)' | grep -m 1 '/debian/*$' || :)
  say "making a root file system of Debian $release in $1"
  # shellcheck disable=SC2086 # one mirror or none
  mmdebstrap --quiet --mode=root --variant=minbase \
    --aptopt='Acquire::Check-Valid-Until "false"' --dpkgopt=force-unsafe-io \
    "$release" "$part" $mirror || {
    rm -rf --one-file-system "$part"
    unavailable "mmdebstrap failed (mirror or network)"
  }
  mv "$part" "$1"
}
