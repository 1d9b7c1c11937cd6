#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
#
# wheel.sh: makes a wheel of the Python package for the system's VTK, in build-wheel/, and tries it: in
# a virtual environment it is installed, draws a picture, and is removed without a trace. For releases
# whose python3-vtk9 pip knows of, Debian testing: `Utilities/matrix.sh testing Utilities/wheel.sh`.
set -eu
# shellcheck source=common.sh
. "$(dirname -- "$0")/common.sh"

"$root/Utilities/packages.sh"
install_packages python3-pip python3-venv python3-scikit-build-core

python=/usr/bin/python3
"$python" -c 'import importlib.metadata as m; m.version("vtk")' 2>/dev/null ||
  fail "pip does not know of the VTK of this system (python3-vtk9 brings no metadata); a wheel could not name it" 77

folder=$root/build-wheel
rm -rf "$folder/dist" "$folder/venv"
mkdir -p "$folder"
say "making the wheel"
# The build folder is kept, so that a second run compiles only what has changed.
"$python" -m pip wheel --no-build-isolation --no-deps --no-index \
  --config-settings=build-dir="$folder/build" --wheel-dir "$folder/dist" "$root"

say "trying it"
"$python" -m venv --system-site-packages "$folder/venv"
pip=$folder/venv/bin/pip
before=$(cd "$folder/venv" && find . -type f ! -name '*.pyc' | sort)
"$pip" install --no-index --no-deps "$folder"/dist/vtkoit-*.whl
"$pip" check 2>&1 | grep -i vtkoit && fail "pip finds something missing"
cd "$folder" # not in the repository, whose folders have the names of packages
"$folder/venv/bin/vtkoit" --version
"$folder/venv/bin/vtkoit" render --help >/dev/null
"$folder/venv/bin/python" "$root/Utilities/wheel_try.py" "$folder/picture.png"
"$pip" uninstall --yes vtkoit
if "$folder/venv/bin/python" -c 'import vtkoit' 2>/dev/null; then
  fail "vtkoit can still be imported after pip uninstall"
fi
after=$(cd "$folder/venv" && find . -type f ! -name '*.pyc' | sort)
[ "$before" = "$after" ] || fail "pip uninstall leaves files in $folder/venv"
say "the wheel is $(ls "$folder"/dist/*.whl)"
