#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
#
# style.sh: checks the tracked files: layout (clang-format 14), licence headers, file lengths.
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
    if [ "$lines" -gt 500 ]; then
      complain "$file: $lines lines; split it (at most 500)"
    elif [ "$lines" -gt 200 ] && [ "${file%.h}" != "$file" ]; then
      printf '%s\n' "$file: note: $lines lines; headers of at most 200 are the aim"
    fi
  done
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
  for file in $(tracked 'vtkOIT/*.cxx' 'Testing/*.cxx' 'Benchmarks/*.cxx'); do
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
check_shell
if [ "${1:-}" = --tidy ]; then
  run_tidy "${2:-}"
fi
[ $status != 0 ] || say "style: no complaints"
exit $status
