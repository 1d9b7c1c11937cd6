#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
#
# style.sh: checks the tracked files: layout (clang-format 14), licence headers, file lengths, and
# that the folders of vtkOIT/Private include each other only downwards.
# style.sh --fix: brings the layout in order instead of checking it.
# style.sh --tidy [BUILD FOLDER]: clang-tidy as well (slow), with the folder's compile commands;
# default build.
#
# shellcheck disable=SC2086 # lists of file names without blanks
set -eu
# shellcheck source=common.sh
. "$(dirname -- "$0")/common.sh"
cd "$root"
status=0
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

complain()
{
  printf '%s\n' "$*" >&2
  status=1
}

tracked()
{
  git ls-files --cached --others --exclude-standard -- "$@" | while read -r file; do
    [ ! -f "$file" ] || printf '%s\n' "$file"
  done
}

check_format()
{
  format=clang-format-14
  command -v $format >/dev/null 2>&1 || install_packages "$format"
  command -v $format >/dev/null 2>&1 || format=clang-format
  command -v $format >/dev/null 2>&1 || fail "clang-format was not found; install version 14"
  sources=$(tracked '*.cxx' '*.h')
  if [ "${1:-}" = --fix ]; then
    $format -i $sources
  elif ! $format --dry-run --Werror $sources; then
    complain "The layout differs from .clang-format; run Utilities/style.sh --fix"
  fi
}

# Every file that can carry the licence in a comment does, in its first lines.
check_licence()
{
  for file in $(tracked '*.cxx' '*.h' '*.glsl' '*.py' '*.sh' '*.cmake' '*.in' '*CMakeLists.txt' \
    .ci/run); do
    for tag in 'SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers' \
      'SPDX-License-Identifier: BSD-3-Clause'; do
      head -n 6 "$file" | grep -qF "$tag" || complain "$file: missing in its head: $tag"
    done
  done
}

check_length()
{
  for file in $(tracked '*.cxx' '*.h' '*.glsl' '*.py' '*.sh' '*.cmake' '*CMakeLists.txt'); do
    lines=$(wc -l <"$file")
    case $file in vtkOIT/*) most=400 ;; *) most=500 ;; esac
    if [ "$lines" -gt "$most" ]; then
      complain "$file: $lines lines; split it (at most $most)"
    elif [ "$lines" -gt 200 ] && [ "${file%.h}" != "$file" ]; then
      printf '%s\n' "$file: note: $lines lines; headers of at most 200 are the aim"
    fi
  done
}

# The floor of a folder of vtkOIT/Private; see its README.md.
floor()
{
  case $1 in
    Frame | Hook) echo 1 ;;
    GL) echo 2 ;;
    Engine) echo 3 ;;
    Volume | Deferred) echo 4 ;;
    ABuffer | Blending | Peeling | Weighted) echo 5 ;;
    Plan) echo 6 ;;
    Auto) echo 7 ;;
    *) echo 0 ;;
  esac
}

# A file includes only files of its own folder and of lower floors, and no public class.
check_arrows()
{
  tracked 'vtkOIT/Private/*.h' 'vtkOIT/Private/*.cxx' | xargs grep -Ho '^#include "[^"]*"' |
    sed 's|^vtkOIT/Private/\([^/]*\)/\([^:]*\):#include "\([^"]*\)"|\1 \2 \3|' >"$scratch/arrows"
  while read -r folder file included; do
    from=$(floor "$folder")
    [ "$from" != 0 ] || complain "vtkOIT/Private/$folder: no floor; add it to Utilities/style.sh"
    case $included in
      Private/*)
        other=${included#Private/}
        other=${other%%/*}
        [ "$other" = "$folder" ] || [ "$(floor "$other")" -lt "$from" ] ||
          complain "vtkOIT/Private/$folder/$file includes $included, which is not below it"
        ;;
      vtkOIT*)
        [ ! -f "vtkOIT/$included" ] ||
          complain "vtkOIT/Private/$folder/$file includes the public $included"
        ;;
    esac
  done <"$scratch/arrows"
  # tsort tells about cycles.
  sed -n 's|^\([^ ]*\) \([^ ]*\.h\) Private/\(.*\)|\1/\2 \3|p' "$scratch/arrows" |
    tsort >/dev/null 2>"$scratch/cycles" || true
  [ ! -s "$scratch/cycles" ] || complain "headers include each other: $(tr '\n' ' ' <"$scratch/cycles")"
}

check_shell()
{
  command -v shellcheck >/dev/null 2>&1 || return 0
  shellcheck Utilities/*.sh .ci/run || complain "shellcheck found the above"
}

run_tidy()
{
  build=${1:-build}
  [ -f "$build/compile_commands.json" ] ||
    fail "no $build/compile_commands.json; run Utilities/test.sh first"
  command -v clang-tidy >/dev/null 2>&1 || install_packages clang-tidy
  # Only what the build compiles: a file of another VTK version has no compile command.
  for file in $(tracked 'vtkOIT/*.cxx' 'Testing/*.cxx'); do
    ! grep -qF "$root/$file\"" "$build/compile_commands.json" || printf '%s\n' "$file"
  done | xargs -r -n 1 -P "$(nproc)" clang-tidy -p "$build" --quiet ||
    complain "clang-tidy found the above"
}

case ${1:-} in
  '' | --fix | --tidy) ;;
  *) fail "unknown argument $1; usage: style.sh [--fix | --tidy [BUILD FOLDER]]" 2 ;;
esac
check_format "${1:-}"
check_licence
check_length
check_arrows
check_shell
if [ "${1:-}" = --tidy ]; then
  run_tidy "${2:-}"
fi
[ $status != 0 ] || say "style: no complaints"
exit $status
