// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Colours, of an adaptive single shot: a fragment goes into the slot of its depth, as one to four words, as
// many as the slots of its pixel leave room for, so that what a slot keeps is of one fragment: colour
// and opacity as they are, as 15 bits each, or as 24 bits and 7.

uniform sampler2DArray oitShot;
uniform sampler2DArray oitTable;

float oitGetChannel(int channel)
{
  vec4 buffer = texelFetch(oitShot, ivec3(gl_FragCoord.xy, channel / 3), 0);
  int i = channel - 3 * (channel / 3);
  return i == 0 ? buffer.x : i == 1 ? buffer.y : buffer.z;
}

vec4 oitGetWords(int i, int slot, int words, vec4 values)
{
  if (words == 4)
  {
    return slot == i ? values : vec4(0.0);
  }
  ivec4 channels = ivec4(4 * i) + ivec4(0, 1, 2, 3);
  vec4 result = mix(vec4(0.0), values.xxxx, equal(channels, ivec4(words * slot)));
  return words == 2 ? mix(result, values.yyyy, equal(channels, ivec4(2 * slot + 1))) : result;
}

void oitWriteColor(int bucket, float depth, vec4 color)
{
  int known = max(bucket, 0);
  float nearest = -oitGetChannel(2 * known);
  float farthest = oitGetChannel(2 * known + 1);
  vec4 entries = texelFetch(oitTable, ivec3(gl_FragCoord.xy, known / 4), 0);
  int entry = int(entries[known - 4 * (known / 4)]);
  int first = entry / 64;
  int between = entry - 64 * first;
  int words = int(texelFetch(oitTable, ivec3(gl_FragCoord.xy, OIT_TABLE_PIXEL), 0).x);
  float share = (depth - nearest) / max(farthest - nearest, 1e-30);
  int slot = first + 1 + clamp(int(share * float(between)), 0, max(between - 1, 0));
  slot = depth == nearest ? first : depth == farthest ? first + 1 + between : slot;
  slot = bucket < 0 ? 64 : slot;

  vec3 compressed = oitCompress(color.rgb);
  vec2 fine = vec2(oitToWord(oitPackFine(compressed.rg)),
    oitToWord(oitPackFine(vec2(compressed.b, max(color.a, 2e-5)))));
  vec4 values = words == 4 ? color : words == 2 ? vec4(fine, 0.0, 0.0)
                                                : vec4(oitToWord(oitPackCoarse(color, 126u)));
  oitOut0 = oitGetWords(0, slot, words, values);
  oitOut1 = oitGetWords(1, slot, words, values);
  oitOut2 = oitGetWords(2, slot, words, values);
  oitOut3 = oitGetWords(3, slot, words, values);
  oitOut4 = oitGetWords(4, slot, words, values);
  oitOut5 = oitGetWords(5, slot, words, values);
  oitOut6 = oitGetWords(6, slot, words, values);
  oitOut7 = oitGetWords(7, slot, words, values);
}
