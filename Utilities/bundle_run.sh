#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
#
# The start script of the archive that Utilities/bundle.sh makes; it is called run.sh there, needs
# a shell and its usual tools only, and can be started from any folder.
set -eu

fail()
{
  printf 'run.sh: %s\n' "$*" >&2
  exit 1
}

self=$(readlink -f -- "$0" 2>/dev/null) || self=$0
here=$(CDPATH='' cd -- "$(dirname -- "$self")" && pwd)
program=$here/bin/vtkOITBenchmark

usage()
{
  cat <<'END'
usage: run.sh [OPTION OF THE BENCHMARK...]   runs the benchmark
       run.sh --libraries                    prints which library comes from where
       run.sh --help

Times vtkOIT's methods and VTK's own, side by side, through EGL: on the GPU whose driver has it,
without a display. The driver's libraries are the system's, everything else is in this folder.
Status 77, with one line, where no EGL draws.

  VTK_DEFAULT_EGL_DEVICE_INDEX=1 run.sh ...  takes another EGL device than the first, 0
  VTKOIT_LIBC=bundle | system                takes this C library, not the newer of the two

END
}

# Versions of the GNU C library are 2.x; anything else (musl) counts as older than ours.
libc_minor()
{
  version=$(getconf GNU_LIBC_VERSION 2>/dev/null) || version=
  case $version in
    'glibc 2.'*) version=${version#glibc 2.} ;;
    *) version=0 ;;
  esac
  printf '%s' "${version%%.*}"
}

# The folders in which the system's driver and what it needs are looked for, each after a colon.
# The loader itself looks into their glibc-hwcaps, for this processor.
system_folders()
{
  PATH=${PATH:-/usr/bin:/bin}:/usr/sbin:/sbin
  {
    ldconfig -p 2>/dev/null | sed -n -e '/glibc-hwcaps/d' -e 's|.* => \(/.*\)/[^/]*$|\1|p'
    printf '%s\n' "/usr/lib/$(uname -m)-linux-gnu" /usr/lib64 /usr/lib /usr/lib/wsl/lib \
      /run/opengl-driver/lib
  } | {
    folders=:
    while read -r folder; do
      case $folders in
        *":$folder:"*) ;;
        *) [ ! -d "$folder" ] || folders=$folders$folder: ;;
      esac
    done
    printf '%s' "${folders%:}"
  }
}

# The loader and the C library must be at least as new as what the system's driver was linked with.
# The bundle's are, but on systems that are newer still; there all that the system has is the
# system's, save VTK.
# start [OPTION OF THE LOADER] PROGRAM [ARGUMENT...]
start()
{
  system=${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}$(system_folders)
  libc=${VTKOIT_LIBC:-}
  if [ -z "$libc" ]; then
    libc=bundle
    [ "$(libc_minor)" -le "$(cat "$here/lib/libc-minor")" ] || libc=system
  fi
  case $libc in
    bundle)
      loader=$here/lib/base/$(cat "$here/lib/loader")
      exec "$loader" --library-path "$here/lib/vtk:$here/lib/base$system" "$@"
      ;;
    system)
      loader=$(cat "$here/lib/loader-path")
      exec "$loader" --library-path "$here/lib/vtk$system:$here/lib/base" "$@"
      ;;
    *) fail "VTKOIT_LIBC=$libc: give bundle or system" ;;
  esac
}

machine=$(cat "$here/lib/machine")
[ "$(uname -s) $(uname -m)" = "$machine" ] ||
  fail "this bundle is for $machine, this machine is $(uname -s) $(uname -m)"

# A machine may have OSMesa as well, which would be preferred and never uses the GPU.
: "${VTK_DEFAULT_OPENGL_WINDOW:=vtkEGLRenderWindow}"
export VTK_DEFAULT_OPENGL_WINDOW

case ${1:-} in
  -h | --help)
    usage
    start "$program" --help
    ;;
  --libraries) start --list "$program" ;;
  *) start "$program" "$@" ;;
esac
