#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Run by packages_test.sh as root in a bare root file system, in a folder with the packages:
# installs them, draws as an ordinary user, moves the archive to another place, purges everything.
set -eu
export DEBIAN_FRONTEND=noninteractive
user=nobody
work=$(mktemp -d)
chmod 755 "$work"

say()
{
  printf '%s\n' "-- $*"
}

fail()
{
  printf 'FAILED: %s\n' "$*"
  exit 1
}

as_user()
{
  setpriv --reuid "$user" --regid nogroup --clear-groups env HOME="$work/home" "$@"
}

install()
{
  apt-get -qq install --yes --no-install-recommends "$@" >"$work/apt.log" 2>&1 || {
    cat "$work/apt.log"
    fail "apt-get install $*"
  }
}

# draw PROGRAM PICTURE: a green square in front of a red one, both of opacity 0.5, over white.
draw()
{
  as_user "$1" render front.vtk back.vtk --color lime red --opacity 0.5 0.5 --camera z --up y \
    --size 64x64 -o "$2" || fail "$1 render"
  as_user /usr/bin/python3 - "$2" <<'PYTHON' || fail "$2: not the right picture"
import sys
from vtkmodules.vtkIOImage import vtkPNGReader

reader = vtkPNGReader()
reader.SetFileName(sys.argv[1])
reader.Update()
image = reader.GetOutput()
color = [image.GetScalarComponentAsDouble(32, 32, 0, channel) for channel in range(3)]
print("   colour in the middle:", color)
# By definition; the other order has 191, 128, 64, and the average is in between.
sys.exit(any(abs(is_ - should) > 8 for is_, should in zip(color, (128, 191, 64))))
PYTHON
}

square()
{
  printf '%s\n' '# vtk DataFile Version 3.0' square ASCII 'DATASET POLYDATA' 'POINTS 4 float' \
    "-1 -1 $1" "1 -1 $1" "1 1 $1" "-1 1 $1" 'POLYGONS 1 5' '4 0 1 2 3' >"$2"
}

mkdir "$work/home"
chown "$user:nogroup" "$work/home"
packages=$PWD
cd "$work/home"
square 0.01 front.vtk
square 0 back.vtk

for compiler in cc gcc g++ c++ clang; do
  ! command -v "$compiler" >/dev/null || fail "this system has a compiler: $compiler"
done
apt-get -qq update >"$work/apt.log" 2>&1 || {
  cat "$work/apt.log"
  fail "apt-get update"
}
say "installing"
# What draws without a display is a recommendation.
windows=$(dpkg-deb -f "$packages"/libvtkoit0*.deb Recommends | tr -d ,)
# shellcheck disable=SC2086 # a list of names
install "$packages"/libvtkoit0*.deb "$packages"/python3-vtkoit_*.deb $windows
! command -v cc >/dev/null || fail "the packages bring a compiler along"
package=/usr/lib/python3/dist-packages/vtkoit
compiled=$(find "$package/__pycache__" -name 'cli.*.pyc' | wc -l)
[ "$compiled" -ge 1 ] || fail "the package was not compiled on installation"
for file in man/man1/vtkoit.1.gz man/man1/vtkoit-conform.1.gz bash-completion/completions/vtkoit \
  zsh/vendor-completions/_vtkoit; do
  # Debian's images of containers leave manual pages out.
  [ -f "/usr/share/$file" ] || dpkg -L python3-vtkoit | grep -q "/usr/share/$file" ||
    fail "/usr/share/$file is missing"
done

say "drawing"
as_user vtkoit --version
as_user vtkoit info
draw vtkoit package.png
as_user python3 -c 'import vtkoit; vtkoit.headless(); print("  ", vtkoit.methods())' || fail "import vtkoit"

say "looking for what libvtkoit-dev needs"
apt-get -qq install --simulate --no-install-recommends "$packages"/libvtkoit-dev_*.deb >"$work/apt.log" 2>&1 || {
  cat "$work/apt.log"
  fail "libvtkoit-dev cannot be installed"
}

say "purging"
apt-get -qq purge --yes '*vtkoit*' >"$work/apt.log" 2>&1 || {
  cat "$work/apt.log"
  fail "apt-get purge"
}
! python3 -c 'import vtkoit' 2>/dev/null || fail "after purge something imports as vtkoit"
python3 -c 'import vtkmodules.vtkCommonCore' || fail "VTK was purged, too"
left=$(find / -xdev -ipath '*vtkoit*' ! -path "$packages*" ! -path '/proc/*' ! -path '/var/log/*')
[ -z "$left" ] || fail "left by purge: $left"

say "drawing from the archive, in a folder of the user's"
install xz-utils
as_user mkdir first
as_user tar -C first -xf "$packages"/vtkoit-*.tar.xz
as_user mv first/vtkoit-* "moved here"
draw "$PWD/moved here/bin/vtkoit" archive.png
cmp package.png archive.png || fail "the archive draws another picture than the package"
say "done: $(sed -n 's/^PRETTY_NAME=//p' /etc/os-release), no compiler"
