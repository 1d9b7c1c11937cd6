// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Gather, for dual depth peeling where shaders can read the framebuffer: of the fragments between
// the layers peeled last, the nearest and the farthest ones are kept, by insertion into the sorted
// groups of the pixel. Fragments come in the order of drawing, so one that joins a group lies on top of
// it, if that is wanted (OIT_LAST_ON_TOP).

uniform int oitFirst; // not 0: the first peel, everything is left
uniform int oitRest;  // not 0: all that is left counts as one group

// In the first peel the statistics: fragments, and 1 in w where there is no room for all. Later, and
// only to read, the depths of the layers peeled last from the front and from the back.
layout(location = OIT_BUFFERS) inout vec4 oitPixel;

#define OIT_LAYER_BUFFER(i) layout(location = i) inout uvec4 oitLayer##i;
#ifdef OIT_FLOAT_COLOR // one layer a side
layout(location = 2) inout uvec4 oitColor0;
layout(location = 3) inout uvec4 oitColor1;
#define OIT_LOAD_LAYER(i) oitKept[i] = oitToLayer(oitLayer##i, oitColor##i);
#define OIT_STORE_LAYER(i)                                                                         \
  oitLayer##i = uvec4(oitKept[i].Key, floatBitsToUint(oitKept[i].Opacity), 0u, 0u);                  \
  oitColor##i = oitKept[i].Color;
#else
#define OIT_LOAD_LAYER(i) oitKept[i] = oitToLayer(oitLayer##i);
#define OIT_STORE_LAYER(i)                                                                         \
  oitLayer##i = uvec4(oitKept[i].Key, oitKept[i].Color, floatBitsToUint(oitKept[i].Opacity));
#endif
//VTK::OIT::LayerBuffers

// Before oitInsert(): a compiler that goes by the order of the text calls the layers uninitialized.
void oitLoadLayers()
{
  //VTK::OIT::LoadLayers
}

// The layer becomes the carried one where that belongs there, which carries what was there on. A
// layer of this key is the one that the fragment joins: it keeps its place.
void oitExchange(inout OITLayer carried, inout OITLayer layer, bool belongs, int key)
{
  OITLayer before = layer;
  bool isNew = belongs || before.Key == key;
  layer.Key = belongs ? carried.Key : before.Key;
  layer.Opacity = isNew ? carried.Opacity : before.Opacity;
  layer.Color = isNew ? carried.Color : before.Color;
  carried.Key = belongs ? before.Key : carried.Key;
  carried.Opacity = belongs ? before.Opacity : carried.Opacity;
  carried.Color = belongs ? before.Color : carried.Color;
}

// Packing is expensive, and a CPU runs both sides of a branch, so one colour is packed: that of the
// fragment, or that of the layer of coincident fragments which it joins. True when the fragment, or
// a layer that had to make room for it, is left out.
bool oitInsert(int key, vec4 color)
{
#ifndef OIT_FLOAT_COLOR
  color.rgb = clamp(color.rgb, vec3(0.0), vec3(65504.0)); // before it goes into a mean
#endif
  OITLayer joined = OITLayer(OIT_NO_NEAR, 0.0, OITPacked(0u));
  for (int i = 0; i < OIT_LAYERS; ++i)
  {
    bool isSame = oitKept[i].Key == key;
    joined.Key = isSame ? key : joined.Key;
    joined.Opacity = isSame ? oitKept[i].Opacity : joined.Opacity;
    joined.Color = isSame ? oitKept[i].Color : joined.Color;
  }
  bool isJoining = joined.Key == key;
  vec4 mean = oitUnpack(joined.Color);
  float opacity = joined.Opacity + (1.0 - joined.Opacity) * color.a;
#ifdef OIT_LAST_ON_TOP
  float weight = opacity;
#else
  float weight = joined.Opacity * mean.a + color.a;
#endif
  vec3 newMean = mean.rgb + (color.rgb - mean.rgb) * (color.a / weight);
#ifdef OIT_FLOAT_COLOR // the smallest that the format tells from 1
  const float smallestRatio = 1.00000012;
#else
  const float smallestRatio = 1.0009765625;
#endif
  OITPacked bits = oitPack(isJoining ? vec4(newMean, max(weight / opacity, smallestRatio))
                                       : vec4(color.rgb, 1.0));

  OITLayer carried =
    OITLayer(isJoining ? OIT_NO_NEAR : key, isJoining ? opacity : color.a, bits);
  for (int i = 0; i < OIT_SIDE; ++i)
  {
    oitExchange(carried, oitKept[i], carried.Key < oitKept[i].Key, key);
  }
  carried.Key = carried.Key == OIT_NO_NEAR ? OIT_NO_FAR : carried.Key;
  for (int i = OIT_SIDE; i < OIT_LAYERS; ++i)
  {
    oitExchange(carried, oitKept[i], carried.Key > oitKept[i].Key, key);
  }
  return carried.Key > OIT_NO_FAR;
}

void main()
{
  oitShade();
  float depth = oitGetDepth();
  vec4 color = oitGetColor();
  bool isFirst = oitFirst != 0;
  bool isLeft = color.a > 0.0 && (isFirst || (depth > oitPixel.x && depth < oitPixel.y));
  int key = oitGetKey(oitRest != 0 ? 0.5 : depth);
  oitLoadLayers();
  int flag = oitKept[OIT_LAYERS - 1].Key & OIT_MORE;
  oitKept[OIT_LAYERS - 1].Key -= flag;
  bool isMore = oitInsert(isLeft ? key : OIT_NO_NEAR, color);
  oitKept[OIT_LAYERS - 1].Key |= isMore ? OIT_MORE : flag;
  //VTK::OIT::StoreLayers
  oitPixel.x += isFirst && isLeft ? 1.0 : 0.0;
  oitPixel.w = isFirst && isMore ? 1.0 : oitPixel.w;
}
