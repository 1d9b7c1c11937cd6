// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Depth of solid fragments, before Gather: the mapper's own shader, renamed oitShade(), leaves its
// colour in oitFragColor, of which only the opacity is used, so compilers drop the lighting. What
// has opacity 1 goes into a copy of the depth buffer, against which Gather is tested; no colours.

void main()
{
  oitShade();
  if (oitGetOpacity() < 1.0)
  {
    discard;
  }
}
