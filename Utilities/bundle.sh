#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
#
# bundle.sh [-o FILE]: packs the benchmark, VTK 9.6 and all other libraries that it needs, the C
# library too, into one archive for Linux machines with a GPU driver and nothing installed, then
# checks the archive. FILE ends in .tar.xz; default: build/vtkOIT-benchmark-linux-<machine>.tar.xz.
#
# Built in the Debian testing of matrix.sh, which needs root or sudo. bundle_run.sh is the start
# script in the archive. Status 77, as matrix.sh, where there can be no Debian testing.
set -eu
# shellcheck source=common.sh
. "$(dirname -- "$0")/common.sh"

release=testing
name=vtkOIT-benchmark-linux-$(uname -m)
largest=60000000 # bytes
build=$root/build-bundle

# Belongs to the graphics driver: another version than the driver's draws nothing. VTK opens libEGL
# at run time, and X11 too, but not for windows of EGL: neither is linked, nor packed.
of_driver()
{
  case $1 in
    libEGL.so.* | libGL.so.* | libGLX.so.* | libGLES*.so.* | libOpenGL.so.* | libGLdispatch.so.* | \
      libgbm.so.* | libdrm*.so.*) return 0 ;;
    *) return 1 ;;
  esac
}

# --- Inside Debian testing -------------------------------------------------------------------------

compile()
{
  cd "$root"
  # No build folder in the libraries: they are found by run.sh alone.
  quietly "$build/configure.log" cmake --preset release -B "$build" -DBUILD_TESTING=OFF \
    -DVTKOIT_WRAP_PYTHON=OFF -DCMAKE_SKIP_BUILD_RPATH=ON
  cmake --build "$build" --target vtkOITBenchmark
}

# add FILE FOLDER [NAME]: a library with the licence of the package that it is from.
add()
{
  cp -L "$1" "$tree/$2/${3:-$(basename -- "$1")}"
  package=$(dpkg-query -S "$(readlink -f -- "$1")" 2>/dev/null || dpkg-query -S "$1" 2>/dev/null) ||
    return 0 # ours
  package=${package%%:*}
  cp -L "/usr/share/doc/$package/copyright" "$tree/licenses/$package"
}

# collect LIST: what ldd printed, into the folders of the archive.
collect()
{
  while read -r library arrow path _; do
    case $library in
      linux-vdso.so.*) continue ;;
      /*)
        printf '%s\n' "$library" >"$tree/lib/loader-path"
        basename -- "$library" >"$tree/lib/loader"
        add "$library" lib/base
        continue
        ;;
    esac
    [ "$arrow $path" != '=> not' ] || fail "$library was not found; it is in no package of packages.sh"
    if of_driver "$library"; then
      continue
    fi
    case $library in
      libvtk*) add "$path" lib/vtk "$library" ;;
      *) add "$path" lib/base "$library" ;;
    esac
  done <"$1"
}

# The rest of the C library. VTK needs no libpthread, libdl or librt any more, but drivers do, and
# those of an older system do not work with our libc.
collect_libc()
{
  dpkg-query -L "$(dpkg-query -S "$(readlink -f "$(cat "$tree/lib/loader-path")")" | sed 's/: .*//')" |
    grep -E '/lib[A-Za-z0-9_]*\.so\.[0-9]+$' >"$build/libc"
  while read -r path; do
    [ -f "$tree/lib/base/$(basename -- "$path")" ] || add "$path" lib/base
  done <"$build/libc"
}

pack()
{
  install_packages xz-utils
  compile
  tree=$build/$name
  rm -rf "$tree"
  mkdir -p "$tree/bin" "$tree/lib/vtk" "$tree/lib/base" "$tree/licenses"
  cp "$build/bin/vtkOITBenchmark" "$tree/bin"
  cp "$root/Utilities/bundle_run.sh" "$tree/run.sh"
  cp "$root/LICENSE" "$tree/licenses/vtkOIT"
  LD_LIBRARY_PATH=$build/lib ldd "$tree/bin/vtkOITBenchmark" >"$build/libraries"
  collect "$build/libraries"
  collect_libc
  printf '%s %s\n' "$(uname -s)" "$(uname -m)" >"$tree/lib/machine"
  getconf GNU_LIBC_VERSION | sed 's/^glibc 2\.//' >"$tree/lib/libc-minor"
  strip --strip-unneeded "$tree"/bin/* "$tree"/lib/vtk/libvtkOIT*
  say "packing $(find "$tree/lib" -name '*.so*' | wc -l) libraries"
  XZ_OPT=-T0 tar -C "$build" --owner=0 --group=0 --sort=name -cJf "$build/$name.tar.xz" "$name"
}

# --- Outside ---------------------------------------------------------------------------------------

# Every library comes from the archive, or belongs to the driver.
check_libraries()
{
  env -i "$1/run.sh" --libraries >"$1/libraries" || fail "run.sh --libraries: status $?"
  while read -r library arrow path _; do
    case $library in
      linux-vdso.so.*) continue ;;
      /*) path=${path:-$library} ;;
    esac
    case $path in
      "$1"/lib/*) continue ;;
    esac
    of_driver "$library" || fail "the archive lacks $library (here: ${arrow:-} $path)"
  done <"$1/libraries"
  grep -q "=> $1/lib/vtk/libvtkRenderingOpenGL2" "$1/libraries" ||
    fail "run.sh --libraries does not name VTK: $(head -n 1 "$1/libraries")"
  [ -f "$1/lib/base/libpthread.so.0" ] || fail "the archive lacks libpthread.so.0"
}

# Draws with what this machine has, from another folder and with an empty environment.
check_run()
{
  status=0
  (cd / && env -i timeout 300 "$1/run.sh" --scenes deep --size 64 --frames 1) \
    >"$1/output" 2>&1 || status=$?
  case $status in
    0)
      if ! grep -q '^window: EGL, ' "$1/output" || ! grep -q '^  auto ' "$1/output"; then
        cat "$1/output" >&2
        fail "run.sh did not draw through EGL"
      fi
      say "it runs: $(grep '^window: ' "$1/output")"
      ;;
    77) say "not run, there is no EGL here: $(tail -n 1 "$1/output")" ;;
    *)
      cat "$1/output" >&2
      fail "run.sh: status $status"
      ;;
  esac
}

check()
{
  bytes=$(wc -c <"$1")
  [ "$bytes" -lt $largest ] || fail "$1 has $bytes bytes, more than $largest"
  folder=$(mktemp -d)
  trap 'rm -rf "$folder"' EXIT
  tar -C "$folder" -xJf "$1"
  check_libraries "$folder/$name"
  check_run "$folder/$name"
  say "$1: $((bytes / 1000000)) MB"
}

file=$root/build/$name.tar.xz
case ${1:-} in
  '') ;;
  --pack) # inside
    pack
    exit
    ;;
  -o)
    [ $# = 2 ] || fail "-o needs the name of a file, such as -o bundle.tar.xz" 2
    file=$2
    ;;
  *) fail "unknown argument $1; usage: bundle.sh [-o FILE]" 2 ;;
esac
case $file in
  *.tar.xz) ;;
  *) fail "$file: the name of the archive ends in .tar.xz" 2 ;;
esac
install_packages xz-utils
mkdir -p "$(dirname -- "$file")"
"$root/Utilities/matrix.sh" --copy "build-bundle/$name.tar.xz" "$file" \
  $release Utilities/bundle.sh --pack
check "$file"
