// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Which buckets the fragments share that no channel has kept, from the sums of their numbers, squares
// and cubes: up to three are found; more are taken to be where their mean is.

float oitLost[OIT_BUCKETS]; // how many are in each

void oitLose(float bucket, float count)
{
  oitLost[int(clamp(bucket + 0.5, 0.0, float(OIT_BUCKETS) - 0.5))] += count;
}

void oitLosePair(float sum, float squares)
{
  float difference = sqrt(max(2.0 * squares - sum * sum, 0.0));
  oitLose(0.5 * (sum - difference), 1.0);
  oitLose(0.5 * (sum + difference), 1.0);
}

void oitFindLost(float count, vec3 powers)
{
  for (int i = 0; i < OIT_BUCKETS; ++i)
  {
    oitLost[i] = 0.0;
  }
  if (count == 2.0)
  {
    oitLosePair(powers.x, powers.y);
  }
  else if (count == 3.0)
  {
    // The roots of a cubic, whose coefficients are those of its power sums.
    float pairs = 0.5 * (powers.x * powers.x - powers.y);
    float product =
      (powers.x * powers.x * powers.x - 3.0 * powers.x * powers.y + 2.0 * powers.z) / 6.0;
    float root = 0.0;
    float least = 1e30;
    for (int i = 0; i < OIT_BUCKETS; ++i)
    {
      float t = float(i);
      float value = abs(((t - powers.x) * t + pairs) * t - product);
      root = value < least ? t : root;
      least = min(value, least);
    }
    oitLose(root, 1.0);
    oitLosePair(powers.x - root, powers.y - root * root);
  }
  else if (count > 0.0)
  {
    oitLose(powers.x / count, count);
  }
}
