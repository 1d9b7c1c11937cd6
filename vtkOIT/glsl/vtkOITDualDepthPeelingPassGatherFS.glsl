// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Gather, for dual depth peeling where shaders can read the framebuffer: of the fragments between
// the layers peeled last, the nearest and the farthest ones are kept, by insertion into the sorted
// groups of the pixel.

uniform int oitFirst; // not 0: the first peel, everything is left
uniform int oitRest;  // not 0: all that is left counts as one group

// In the first peel the statistics: fragments, and 1 in w where there is no room for all. Later the
// depths of the layers peeled last from the front and from the back, and the 1 in z.
layout(location = OIT_BUFFERS) inout vec4 oitPixel;

#define OIT_LAYER_BUFFER(i) layout(location = i) inout uvec4 oitLayer##i;
#ifdef OIT_FLOAT_COLOR // one layer a side
layout(location = 2) inout uvec4 oitColor0;
layout(location = 3) inout uvec4 oitColor1;
#define OIT_LOAD_LAYER(i) layers[i] = oitToLayer(oitLayer##i, oitColor##i);
#define OIT_STORE_LAYER(i)                                                                         \
  oitLayer##i = uvec4(layers[i].Key, floatBitsToUint(layers[i].Opacity), 0u, 0u);                  \
  oitColor##i = layers[i].Color;
#else
#define OIT_LOAD_LAYER(i) layers[i] = oitToLayer(oitLayer##i);
#define OIT_STORE_LAYER(i)                                                                         \
  oitLayer##i = uvec4(layers[i].Key, layers[i].Color, floatBitsToUint(layers[i].Opacity));
#endif
//VTK::OIT::LayerBuffers

// The layer with one more fragment.
OITLayer oitMerge(OITLayer layer, OITLayer fragment)
{
  vec4 mean = oitUnpack(layer.Color);
  vec3 color = oitUnpack(fragment.Color).rgb;
  float weight = layer.Opacity * mean.a + fragment.Opacity;
  float opacity = layer.Opacity + (1.0 - layer.Opacity) * fragment.Opacity;
  vec3 newMean = mean.rgb + (color - mean.rgb) * (fragment.Opacity / weight);
  const float smallestRatio = 1.0009765625; // that a half tells from 1
  return OITLayer(
    layer.Key, opacity, oitPack(vec4(newMean, max(weight / opacity, smallestRatio))));
}

// True when the fragment, or a layer that had to make room for it, is left out.
bool oitInsert(OITLayer fragment)
{
  // Merging is expensive on a CPU, which runs both sides of a branch: once, for any layer.
  OITLayer same = fragment;
  for (int i = 0; i < OIT_LAYERS; ++i)
  {
    bool isSame = layers[i].Key == fragment.Key;
    same.Opacity = isSame ? layers[i].Opacity : same.Opacity;
    same.Color = isSame ? layers[i].Color : same.Color;
  }
  OITLayer merged = oitMerge(same, fragment);
  bool isMerged = false;
  for (int i = 0; i < OIT_LAYERS; ++i)
  {
    bool isSame = layers[i].Key == fragment.Key;
    layers[i].Opacity = isSame ? merged.Opacity : layers[i].Opacity;
    layers[i].Color = isSame ? merged.Color : layers[i].Color;
    isMerged = isMerged || isSame;
  }

  OITLayer carried = fragment;
  carried.Key = isMerged ? OIT_NO_NEAR : fragment.Key;
  for (int i = 0; i < OIT_SIDE; ++i)
  {
    OITLayer layer = layers[i];
    bool isBefore = carried.Key < layer.Key;
    layers[i].Key = isBefore ? carried.Key : layer.Key;
    layers[i].Opacity = isBefore ? carried.Opacity : layer.Opacity;
    layers[i].Color = isBefore ? carried.Color : layer.Color;
    carried.Key = isBefore ? layer.Key : carried.Key;
    carried.Opacity = isBefore ? layer.Opacity : carried.Opacity;
    carried.Color = isBefore ? layer.Color : carried.Color;
  }
  carried.Key = carried.Key == OIT_NO_NEAR ? OIT_NO_FAR : carried.Key;
  for (int i = OIT_SIDE; i < OIT_LAYERS; ++i)
  {
    OITLayer layer = layers[i];
    bool isBehind = carried.Key > layer.Key;
    layers[i].Key = isBehind ? carried.Key : layer.Key;
    layers[i].Opacity = isBehind ? carried.Opacity : layer.Opacity;
    layers[i].Color = isBehind ? carried.Color : layer.Color;
    carried.Key = isBehind ? layer.Key : carried.Key;
    carried.Opacity = isBehind ? layer.Opacity : carried.Opacity;
    carried.Color = isBehind ? layer.Color : carried.Color;
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
  //VTK::OIT::LoadLayers
  bool isMore =
    oitInsert(OITLayer(isLeft ? key : OIT_NO_NEAR, color.a, oitPack(vec4(color.rgb, 1.0))));
  //VTK::OIT::StoreLayers
  oitPixel.x += isFirst && isLeft ? 1.0 : 0.0;
  oitPixel.z = isMore && !isFirst ? 1.0 : oitPixel.z;
  oitPixel.w = isMore && isFirst ? 1.0 : oitPixel.w;
}
