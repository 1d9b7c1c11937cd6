//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Equalize: the non-empty bins of a pixel's histogram become buckets, one each. With more than 32
// of them, neighbours share a bucket.

uniform usampler2DArray oitHistogram;

layout(location = 0) out vec4 oitBounds0;
layout(location = 1) out vec4 oitBounds1;
layout(location = 2) out vec4 oitBounds2;
layout(location = 3) out vec4 oitBounds3;
layout(location = 4) out vec4 oitBounds4;
layout(location = 5) out vec4 oitBounds5;
layout(location = 6) out vec4 oitBounds6;
layout(location = 7) out vec4 oitBounds7;

void main()
{
  float bounds[32];
  int used = 0; // non-empty bins
  uint words[32];
  for (int layer = 0; layer < 8; ++layer)
  {
    uvec4 word = texelFetch(oitHistogram, ivec3(gl_FragCoord.xy, layer), 0);
    words[4 * layer] = word.x;
    words[4 * layer + 1] = word.y;
    words[4 * layer + 2] = word.z;
    words[4 * layer + 3] = word.w;
  }
  for (int i = 0; i < 32; ++i)
  {
    bounds[i] = 1e6; // behind all bins
    for (uint rest = words[i]; rest != 0u; rest &= rest - 1u)
    {
      ++used;
    }
  }
  int share = max((used + 31) / 32, 1); // bins of a bucket
  int seen = 0;
  for (int bin = 0; bin < OIT_BINS; ++bin)
  {
    if (((words[bin / 32] >> uint(bin - 32 * (bin / 32))) & 1u) != 0u)
    {
      bounds[seen / share] = float(bin); // the last one stays
      ++seen;
    }
  }
  oitBounds0 = vec4(bounds[0], bounds[1], bounds[2], bounds[3]);
  oitBounds1 = vec4(bounds[4], bounds[5], bounds[6], bounds[7]);
  oitBounds2 = vec4(bounds[8], bounds[9], bounds[10], bounds[11]);
  oitBounds3 = vec4(bounds[12], bounds[13], bounds[14], bounds[15]);
  oitBounds4 = vec4(bounds[16], bounds[17], bounds[18], bounds[19]);
  oitBounds5 = vec4(bounds[20], bounds[21], bounds[22], bounds[23]);
  oitBounds6 = vec4(bounds[24], bounds[25], bounds[26], bounds[27]);
  oitBounds7 = vec4(bounds[28], bounds[29], bounds[30], bounds[31]);
}
