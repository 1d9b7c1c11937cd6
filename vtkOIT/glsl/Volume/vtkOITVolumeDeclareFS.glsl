// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What stands among the declarations of a volume mapper's shader, for March.

//VTK::OIT::Node
//VTK::OIT::Read

uniform float oitThreshold; // of the transmittance
uniform int oitIsAlone;     // 1: there is one volume, which takes what is in front of it, too

float oitLimit = 1e30;        // samples after which castRay() returns
vec4 oitBefore = vec4(0.0);   // the ray's colour before its last sample
#ifdef OIT_ISOSURFACES
int oitInterval = 0; // between two isovalues, of the last sample: castRay() forgets it
#endif
