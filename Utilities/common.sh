# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=sh disable=SC2086 # $missing is a list of names
#
# Sourced by the other scripts of this folder, after `set -eu`.

# The repository, whatever folder the script was started from.
root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)

# Mesa keeps compiled shaders in the home folder; ours stay inside the repository.
MESA_SHADER_CACHE_DIR=$root/build/mesa-shader-cache
MESA_GLSL_CACHE_DIR=$MESA_SHADER_CACHE_DIR
export MESA_SHADER_CACHE_DIR MESA_GLSL_CACHE_DIR

say()
{
  printf '%s\n' "== $*"
}

# fail MESSAGE [STATUS]
fail()
{
  printf '%s: %s\n' "$(basename -- "$0")" "$1" >&2
  exit "${2:-1}"
}

# Runs a command as root: directly, or through sudo for a user who has it.
as_root()
{
  if [ "$(id -u)" = 0 ]; then
    "$@"
  elif command -v sudo >/dev/null 2>&1; then
    sudo "$@"
  else
    fail "needs root for: $* (there is no sudo; run it as root, then this script again)"
  fi
}

package_installed()
{
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

# install_packages NAME...: installs what is missing; silent and quick when nothing is. A name that
# ends in ? is left out where the distribution does not have it.
install_packages()
{
  if ! command -v apt-get >/dev/null 2>&1; then
    say "no apt-get on this system; these must be there already, whatever their names here:" "$@"
    return 0
  fi
  missing=$(missing_packages "$@")
  [ -n "$missing" ] || return 0
  if ! packages_known; then
    fetch_package_lists
    missing=$(missing_packages "$@")
    [ -n "$missing" ] || return 0
  fi

  say "installing:" $missing
  if ! apt_install $missing; then
    # Lists that are older than the mirror name files that are gone.
    fetch_package_lists
    apt_install $missing || fail "apt-get could not install:$missing"
  fi
}

# Those of the names that are to be installed, each after a space.
missing_packages()
{
  for package in "$@"; do
    name=${package%\?}
    if package_installed "$name"; then
      continue
    fi
    if [ "$name" = "$package" ] || ! packages_known ||
      apt-cache show "$name" >/dev/null 2>&1; then
      printf ' %s' "$name"
    fi
  done
}

# Whether apt has lists of packages at all: a fresh system has none.
packages_known()
{
  [ -n "$(apt-get indextargets --format '$(FILENAME)' 'Created-By: Packages' | head -n 1)" ]
}

fetch_package_lists()
{
  say "fetching the package lists"
  as_root apt-get -qq update || fail "apt-get update failed; check the network and apt's sources"
}

# Packages chatter while they are set up; only a failure is worth reading.
apt_install()
{
  chatter=$(mktemp)
  status=0
  as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get -qq install --yes --no-install-recommends "$@" >"$chatter" 2>&1 || status=$?
  [ "$status" = 0 ] || cat "$chatter" >&2
  rm -f "$chatter"
  return "$status"
}

# quietly LOG COMMAND...: the output goes to the file, and to the terminal when the command fails.
quietly()
{
  log=$1
  shift
  mkdir -p "$(dirname -- "$log")"
  if ! "$@" >"$log" 2>&1; then
    cat "$log" >&2
    fail "failed: $*"
  fi
  # CMake warns on a successful configuration too; that must not go unseen.
  if grep -q 'CMake.*Warning' "$log"; then
    cat "$log" >&2
  fi
}
