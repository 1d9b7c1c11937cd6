#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
#
# packages_test.sh [RELEASE]: makes the packages of a Debian release (default: this one), looks at
# them with lintian, and installs, uses and purges them in a bare root file system of that release,
# which has no compiler (packages_test_inside.sh).
# packages_test.sh --make: only makes them here, into build-packages/packages.tar.
#
# Status: 0, 1 for what fails, 77 with one line when no root file system can be made or entered.
set -eu
# shellcheck source=common.sh
. "$(dirname -- "$0")/common.sh"

make_packages()
{
  "$root/Utilities/packages.sh"
  install_packages dpkg-dev file gzip lintian
  say "making the packages in $root/build-packages"
  cd "$root"
  quietly build-packages/configure.log cmake --preset packages
  quietly build-packages/build.log cmake --build --preset packages
  rm -rf build-packages/packages
  quietly build-packages/cpack.log cpack --preset packages
  # Errors only; as root it says that this is not recommended.
  lintian --fail-on error --tag-display-limit 0 build-packages/packages/*.deb 2>build-packages/lintian.log ||
    fail "lintian found the errors above"
  tar -C build-packages/packages --exclude=_CPack_Packages -cf build-packages/packages.tar .
}

own=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release 2>/dev/null || :)
case ${1:-} in
  --make)
    make_packages
    exit 0
    ;;
  -*) fail "usage: packages_test.sh [RELEASE | --make]" 2 ;;
esac
release=${1:-$own}

unavailable()
{
  fail "the packages are not tested in Debian $release: $*" 77
}

[ "$(id -u)" = 0 ] || unavailable "chroot needs root; run it as root, or by sudo"
[ -n "$release" ] || unavailable "this is no Debian system"
# shellcheck source=rootfs.sh
. "$(dirname -- "$0")/rootfs.sh"
check_rootfs

scratch=$(mktemp -d "$cache/packages-XXXXXX")
trap 'rm -rf --one-file-system "$scratch"' EXIT
if [ "$release" = "$own" ]; then
  make_packages
  cp "$root/build-packages/packages.tar" "$scratch"
else
  "$root/Utilities/matrix.sh" --copy build-packages/packages.tar "$scratch/packages.tar" \
    "$release" Utilities/packages_test.sh --make
fi

bare=$cache/bare-$release-$(dpkg --print-architecture).tar
[ -f "$bare" ] || make_rootfs "$bare"
rootfs=$scratch/rootfs
mkdir -p "$rootfs"
tar -C "$rootfs" -xf "$bare"
mkdir "$rootfs/vtkoit"
tar -C "$rootfs/vtkoit" -xf "$scratch/packages.tar"
cp "$root/Utilities/packages_test_inside.sh" "$rootfs/vtkoit"
cp -L /etc/resolv.conf "$rootfs/etc/resolv.conf" 2>/dev/null || :
say "in a bare Debian $release"
inside "$rootfs" /vtkoit sh -eu ./packages_test_inside.sh
