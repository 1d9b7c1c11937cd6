#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
#
# zink.sh [--validate] [CTEST OPTION...]: runs tests of build/ by Mesa's zink over lavapipe, OpenGL
# over Vulkan in software. Shaders cannot read the framebuffer there and have the fragment shader
# interlock, as on NVIDIA's GPUs, and blending is the blend unit's. For Debian 13 and later:
# `Utilities/matrix.sh testing Utilities/zink.sh`, after the tests were built there.
#
# Without options of ctest: one test of each thing that is done in another way there, of the methods
# that can do it, in about two minutes. `zink.sh -L stress` is the whole stress suite.
#
# --validate: under Vulkan's validation layer, with its check of synchronization; then prints what it
# said, each kind once with the number of times.
set -eu
# shellcheck source=common.sh
. "$(dirname -- "$0")/common.sh"

validate=
if [ "${1:-}" = --validate ]; then
  validate=yes
  shift
fi

install_packages mesa-vulkan-drivers ${validate:+vulkan-validationlayers}
VK_DRIVER_FILES=
for file in /usr/share/vulkan/icd.d/lvp_icd*.json; do
  [ ! -f "$file" ] || VK_DRIVER_FILES=$file
done
[ -n "$VK_DRIVER_FILES" ] || fail "mesa-vulkan-drivers has no lavapipe here"
export VK_DRIVER_FILES
export LIBGL_ALWAYS_SOFTWARE=1 MESA_LOADER_DRIVER_OVERRIDE=zink GALLIUM_DRIVER=zink
cd "$root"
build/bin/vtkoit info 2>/dev/null | grep -q '^renderer *zink' ||
  fail "OpenGL is not drawn by zink here (build/bin/vtkoit info says by what; Mesa 24 or later, EGL)"

# What depends on framebuffer fetch, interlock, blending or depth formats:
#   colours and depths of fragments, coincident ones, framebuffers of other formats; opaque geometry
#   that hides fragments; state of OpenGL left as it was; layers that are kept and reused; samples;
#   the order of drawing, light, volumes, deferred shading.
tests='FragmentColors|FragmentDepth|CoincidentLayers|OffscreenFormats|OpaqueOcclusion|GLState'
tests="$tests|LastOnTop|Light|DeferredLights|Impostors|Multisampling|Skipping|PeelingStatistics|PeelingEnds|CrossingQuads"
methods='auto|abuffer|peel|dual|multilayer|bucket|deferred-abuffer'
[ $# -gt 0 ] || set -- -R "Cxx-Test($tests)-($methods)\$|TestAutoPassReuse|TestAutoPassChoice|TestVolume(Slabs|Modes|Order)-(auto|abuffer)\$"

if [ -z "$validate" ]; then
  ctest --test-dir build --output-on-failure --no-tests=error --parallel "$(nproc)" \
    --label-exclude '^long$' "$@"
  exit
fi

export VK_INSTANCE_LAYERS=VK_LAYER_KHRONOS_validation VK_LAYER_VALIDATE_SYNC=1
log=$root/build/zink-validation.log
status=0
ctest --test-dir build --verbose --no-tests=error --parallel "$(nproc)" --label-exclude '^long$' \
  "$@" >"$log" 2>&1 || status=$?
grep '% tests passed' "$log" || :
say "the validation layer's messages, from $log:"
# The line below the name of a message says which command; numbers differ from one to the next.
grep -a -A 3 'Validation \(Error\|Warning\)' "$log" | grep -aoE 'vk[A-Z][A-Za-z0-9]*\(\).{0,300}' |
  sed -E 's/0x[0-9a-f]+|[0-9]{2,}/N/g' | sort | uniq -c | sort -rn | head -n 40
exit "$status"
