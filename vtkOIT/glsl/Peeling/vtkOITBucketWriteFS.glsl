// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What the buckets of a pixel hold, four values in each of eight layers.

layout(location = 0) out vec4 oitLayer0;
layout(location = 1) out vec4 oitLayer1;
layout(location = 2) out vec4 oitLayer2;
layout(location = 3) out vec4 oitLayer3;
layout(location = 4) out vec4 oitLayer4;
layout(location = 5) out vec4 oitLayer5;
layout(location = 6) out vec4 oitLayer6;
layout(location = 7) out vec4 oitLayer7;

void oitWrite(float values[32])
{
  oitLayer0 = vec4(values[0], values[1], values[2], values[3]);
  oitLayer1 = vec4(values[4], values[5], values[6], values[7]);
  oitLayer2 = vec4(values[8], values[9], values[10], values[11]);
  oitLayer3 = vec4(values[12], values[13], values[14], values[15]);
  oitLayer4 = vec4(values[16], values[17], values[18], values[19]);
  oitLayer5 = vec4(values[20], values[21], values[22], values[23]);
  oitLayer6 = vec4(values[24], values[25], values[26], values[27]);
  oitLayer7 = vec4(values[28], values[29], values[30], values[31]);
}
