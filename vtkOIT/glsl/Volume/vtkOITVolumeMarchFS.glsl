// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// March: a volume mapper's ray walks the sorted list of its pixel, and writes both in the order
// along the ray. Replaces the mapper's main(); its castRay() is left as it is, but returns after
// oitLimit samples, and goes on when it is called again.
//
// Distances are counted in steps of the ray, from the place where the interval of the first sample
// starts: sample i stands for [i, i + 1). A fragment at t divides the sample floor(t): what that has
// added is taken back, and put in again in two parts of the same density, 1 - (1 - alpha)^f and
// 1 - (1 - alpha)^(1 - f), with the fragment between them. What a sample adds is found from the
// ray's colour before and after it, so it does not matter how the mapper finds that.
//
// Where there are several volumes, they are drawn back to front, each takes the fragments behind its
// entry, and cuts them off the list. What is left over, Composite draws.

uint oitNode = OIT_END; // the next fragment
OITFragment oitNext = OIT_NO_FRAGMENT;
vec2 oitDistances = vec2(0.0); // of window depths 0 and 1 in steps, homogeneous
vec2 oitWeights = vec2(1.0);
bool oitIsCut = false; // the ray has ended at the threshold

void oitGoTo(uint node)
{
  oitNext = OIT_NO_FRAGMENT;
  oitNode = node;
#if OIT_SAMPLES > 0
  while (oitNode != OIT_END)
  {
    oitNext = oitRead(oitNode);
    if (((oitNext.Mask >> uint(gl_SampleID)) & 1u) != 0u)
    {
      break;
    }
    oitNode = oitNext.Next;
  }
#else
  if (oitNode != OIT_END)
  {
    oitNext = oitRead(oitNode);
  }
#endif
}

// Of the next fragment.
float oitFindDistance()
{
  float depth = uintBitsToFloat(oitNext.Key);
  float distance = mix(oitDistances.x, oitDistances.y, depth) / mix(oitWeights.x, oitWeights.y, depth);
  return oitNode == OIT_END ? 1e30 : distance;
}

// Colours are premultiplied.
void oitAddBehind(vec4 layer)
{
  g_fragColor += (1.0 - g_fragColor.a) * layer;
}

// The next group of coincident fragments, as Composite sees it. The mapper scales the colour at last
// (FinalColorWindow), which is not meant for fragments.
void oitAddGroup()
{
  uint key = oitNext.Key;
  float opacity = 0.0;
  float weight = 0.0;
  vec3 weighted = vec3(0.0);
  vec3 light = vec3(0.0);
  do
  {
    vec4 c = oitUnpack(oitNext.Color);
    float cover = oitGetCover(c);
    opacity += (1.0 - opacity) * cover;
    weight += cover;
    weighted += cover * c.rgb;
#ifdef OIT_HAS_LIGHT
    light += oitGetAdded(c);
#endif
    oitGoTo(oitNext.Next);
  } while (oitNode != OIT_END && OIT_IS_OF_GROUP(oitNext));
  vec3 color = light + weighted * (opacity / max(weight, 1e-30));
  oitAddBehind(vec4((color - in_bias * opacity) / in_scale, opacity));
}

bool oitIsAtEnd()
{
  return 1.0 - g_fragColor.a <= oitThreshold;
}

// A part of a sample: its share of the optical depth.
void oitAddPart(vec4 whole, float share)
{
  float opacity = clamp(whole.a, 0.0, 0.999999);
  float part = opacity > 1e-5 ? (1.0 - pow(1.0 - opacity, share)) / opacity : share;
  oitAddBehind(whole * min(part, 1.0));
}

vec4 oitToTexture(float depth)
{
  return ip_inverseTextureDataAdjusted *
    (in_inverseVolumeMatrix[0] *
      (in_inverseModelViewMatrix *
        (in_inverseProjectionMatrix * WindowToNDC(gl_FragCoord.x, gl_FragCoord.y, depth))));
}

void oitFindRay()
{
  vec3 origin = g_dataPos - g_dirStep;
  vec3 along = g_dirStep / dot(g_dirStep, g_dirStep);
  vec4 near = oitToTexture(0.0);
  vec4 far = oitToTexture(1.0);
  oitWeights = vec2(near.w, far.w);
  oitDistances =
    vec2(dot(near.xyz - near.w * origin, along), dot(far.xyz - far.w * origin, along));
}

#if OIT_VOLUME_MODE == OIT_VOLUME_MARCHED
void oitMarch()
{
  float done = 1.0; // share of the last sample that is in the colour
  vec4 last = vec4(0.0);
  float lastSample = -1.0;
  bool isMarching = !oitIsAtEnd();
  oitIsCut = !isMarching;
  while (true)
  {
    float at = oitFindDistance();
    float divided = floor(at);
    if (isMarching && divided >= g_currentT)
    {
      if (done < 1.0)
      {
        oitAddPart(last, 1.0 - done);
        done = 1.0;
      }
      oitLimit = divided + 1.0;
      castRay(-1.0, -1.0);
      isMarching = g_currentT >= oitLimit;
      if (g_currentT >= divided)
      {
        last = (g_fragColor - oitBefore) / max(1.0 - oitBefore.a, 1e-6);
        g_fragColor = oitBefore;
        lastSample = divided;
        done = 0.0;
      }
    }
    if (oitNode == OIT_END || oitIsAtEnd())
    {
      break;
    }
    if (done < 1.0)
    {
      float share = clamp(at - lastSample, done, 1.0);
      oitAddPart(last, share - done);
      done = share;
    }
    oitAddGroup();
  }
  if (done < 1.0)
  {
    oitAddPart(last, 1.0 - done);
  }
}
#else
// A projection has no order along the ray: it is one layer, where the ray enters the volume. A slice
// is one where it is.
void oitMarch()
{
#if OIT_VOLUME_MODE == OIT_VOLUME_SLICE
  vec4 place = ip_inverseTextureDataAdjusted * (in_textureDatasetMatrix[0] * vec4(g_intersection, 1.0));
  vec3 along = g_dirStep / dot(g_dirStep, g_dirStep);
  float layer = dot(place.xyz / place.w - (g_dataPos - g_dirStep), along);
  while (oitFindDistance() < layer && !oitIsAtEnd())
  {
    oitAddGroup();
  }
#endif
  vec4 before = g_fragColor;
  g_fragColor = vec4(0.0);
  castRay(-1.0, -1.0);
  vec4 projected = g_fragColor;
  g_fragColor = before;
  oitAddBehind(projected);
  while (oitNode != OIT_END && !oitIsAtEnd())
  {
    oitAddGroup();
  }
}
#endif

// Fragments that this volume has taken are not drawn again.
void oitNoteTaken(ivec2 pixel, uint head, uint lastInFront)
{
#if OIT_SAMPLES > 0
  // Other samples of the pixel take theirs by themselves.
  atomicOr(oitNodeWords[4u * OIT_WORD(head) + 2u], 1u << uint(gl_SampleID));
#else
  if (oitIsAlone != 0)
  {
    imageStore(oitHeads, pixel, uvec4(head | OIT_LEFT));
  }
  else if (lastInFront == OIT_END)
  {
    imageStore(oitHeads, pixel, uvec4(OIT_END));
  }
  else
  {
    oitStoreNext(OIT_WORD(lastInFront), OIT_END);
  }
#endif
}

void main()
{
#if __VERSION__ >= 450
  // On llvmpipe pixels that a triangle does not cover run along, and see no list: others would wait
  // at each fragment until their rays have ended.
  if (gl_HelperInvocation)
  {
    return;
  }
#endif
  initializeRayCast();
  ivec2 pixel = ivec2(gl_FragCoord.xy) - oitOrigin;
  uint head = imageLoad(oitHeads, pixel).x;
  oitFindRay();
  float entry = 1.0 - dot(g_rayJitter, g_dirStep) / dot(g_dirStep, g_dirStep);
  oitGoTo(head);
  uint lastInFront = OIT_END;
  while (oitFindDistance() < entry && !oitIsAtEnd())
  {
    if (oitIsAlone != 0)
    {
      oitAddGroup();
    }
    else
    {
      lastInFront = oitNode;
      oitGoTo(oitNext.Next);
    }
  }
  oitMarch();
  if ((oitIsCut || oitNode != OIT_END) && oitIsAtEnd() && g_fragColor.a < 1.0)
  {
    atomicMax(oitSkipped, floatBitsToUint(1.0 - g_fragColor.a));
  }
  if (head != OIT_END)
  {
    oitNoteTaken(pixel, head, lastInFront);
  }
  finalizeRayCast();
}
