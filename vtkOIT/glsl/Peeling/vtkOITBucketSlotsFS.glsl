//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Resolve, of an adaptive single shot: the slots in order, front to back. Where as many are filled as there
// are fragments, each has its own, and all is there.

//VTK::OIT::State
//VTK::OIT::Words

uniform sampler2DArray oitShot;   // depths of the buckets
uniform sampler2DArray oitTable;  // slots of the buckets
uniform sampler2DArray oitColors; // of the slots
uniform int oitStage;

// 16 layers of 15 bits are off by less than those of half floats are, where these do: if compressed, up
// to this colour.
#ifdef OIT_FLOAT_COLOR
#define OIT_FINE_ERROR 0.008
#else
#define OIT_FINE_ERROR 0.0
#endif
const float OIT_BRIGHT = 4.0;

int oitWords = 1;

vec4 oitLoadSlot(int slot)
{
  int channel = oitWords * slot;
  vec4 words = texelFetch(oitColors, ivec3(gl_FragCoord.xy, min(channel / 4, 7)), 0);
  words = (channel & 2) != 0 ? words.zwzw : words;
  words = (channel & 1) != 0 ? words.yyyy : words;
  bool isEmpty = oitWords == 4 ? words.w <= 0.0 : words.x <= 0.0;
  if (isEmpty || channel >= 32)
  {
    return vec4(0.0);
  }
  if (oitWords == 4)
  {
    return words;
  }
  vec4 fine = vec4(oitUnpackFine(oitFromWord(words.x)), oitUnpackFine(oitFromWord(words.y)));
  fine.rgb = oitExpand(fine.rgb);
  return oitWords == 2 ? fine : oitUnpackCoarse(oitFromWord(words.x), 126u);
}

float oitGetChannel(int channel)
{
  return texelFetch(oitShot, ivec3(gl_FragCoord.xy, channel / 3), 0)[channel - 3 * (channel / 3)];
}

// Fragments that a slot stands for, of which it has kept one.
void oitBlend(vec4 color, float count)
{
  float opacity = count > 1.0 ? 1.0 - exp(-count * oitToOpticalDepth(color.a)) : color.a;
  oitBlendUnder(opacity * color.rgb, opacity);
}

void main()
{
  oitLoadCommonState();
  if (oitStage == OIT_SHOT_RANGE)
  {
    vec4 depths = texelFetch(oitShot, ivec3(gl_FragCoord.xy, 0), 0);
    oitSetBounds(-depths.x, depths.y);
    return;
  }
  float fragments = texelFetch(oitShot, ivec3(gl_FragCoord.xy, 6), 0).a;
#ifdef OIT_IN_PLACE
  if (fragments == 0.0)
  {
    discard; // the state stays as it is
  }
#endif
  vec4 pixel = texelFetch(oitTable, ivec3(gl_FragCoord.xy, OIT_TABLE_PIXEL), 0);
  pixel = fragments > 0.0 ? pixel : vec4(1.0, 0.0, 0.0, 0.0); // it has no table
  oitWords = int(pixel.x);
  float filled = 0.0;
  float brightest = 0.0;
  float depth = 0.0; // optical
  if (oitWords == 1)
  {
    for (int slot = 0; slot < 32; ++slot)
    {
      depth += oitToOpticalDepth(oitLoadSlot(slot).a);
    }
  }
  for (int i = 0; i < OIT_BUCKETS && pixel.z > 0.0; ++i)
  {
    float counts = texelFetch(oitShot, ivec3(gl_FragCoord.xy, i / 2), 0).a;
    float odd = floor(counts / float(OIT_COUNT_BASE));
    float count = (i & 1) != 0 ? odd : counts - odd * float(OIT_COUNT_BASE);
    if (count > 0.0)
    {
      int entry = int(texelFetch(oitTable, ivec3(gl_FragCoord.xy, i / 4), 0)[i - 4 * (i / 4)]);
      int first = entry / 64;
      int between = entry - 64 * first;
      bool isPair = oitGetChannel(2 * i + 1) > -oitGetChannel(2 * i);
      int last = first + (isPair ? between + 1 : 0);
      float here = 0.0;
      for (int slot = first; slot <= last; ++slot)
      {
        here += oitLoadSlot(slot).a > 0.0 ? 1.0 : 0.0;
      }
      float inside = here - (isPair ? 2.0 : 1.0); // slots filled between
      float share = (count - (isPair ? 2.0 : 1.0)) / max(inside, 1.0); // of the fragments there
      share = inside > 0.0 ? max(share, 1.0) : 1.0;
      for (int slot = first; slot <= last; ++slot)
      {
        vec4 color = oitLoadSlot(slot);
        if (oitWords == 1 && here == count)
        {
          // The sum of all optical depths is known better than each.
          color.a = 1.0 - exp(-oitToOpticalDepth(color.a) * pixel.w / max(depth, 1e-30));
        }
        brightest = max(brightest, max(color.r, max(color.g, color.b)));
        bool isInside = slot > first && slot < last;
        oitBlend(color, isInside ? share : isPair ? 1.0 : count);
      }
      filled += here;
    }
  }
  float lost = max(pixel.z - filled, 0.0);
  oitState1.x += pixel.z;
  oitState1.w += lost;
  if (pixel.z > 0.0)
  {
    bool isCoarse = oitWords == 1 || (oitWords == 2 && brightest > OIT_BRIGHT);
    oitNoteError(lost > 0.0 || isCoarse ? 1.0 : oitWords == 2 ? OIT_FINE_ERROR : 0.0);
  }
  oitSetBounds(2.0, -2.0);
}
