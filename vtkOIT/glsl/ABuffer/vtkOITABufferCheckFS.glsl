//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Check: a pixel for each region, after Gather. A region that has given out more nodes than it has gave
// those of the next one, so the lists are not to be read: notes an overflow, and the frame is drawn again.

//VTK::OIT::Node

uniform int oitRegionColumns;
uniform int oitFirstRegionWord;

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy) - oitCorner;
  int region = oitFirstRegionWord + OIT_REGION_WORDS * (at.y * oitRegionColumns + at.x);
  if (oitCounterWords[region] > oitCounterWords[region + OIT_REGION_END])
  {
    oitOverflow = 1u;
  }
}
