//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Equalize: the non-empty bins of a pixel's histogram become buckets, one each. With more than 32
// of them, neighbours share a bucket.

uniform usampler2DArray oitHistogram;

//VTK::OIT::Write

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
  oitWrite(bounds);
}
