// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITFrameSignature_h
#define vtkOITFrameSignature_h

#include "vtkType.h"

#include <cstdint>
#include <vector>

class vtkMapper;
class vtkProp;
struct vtkOITFrame;

/**
 * Everything that the translucent layer of a frame is made from, as numbers, but for the depth of
 * the opaque geometry (vtkOITDepthCheck): camera, viewport, lights, and of each prop the time of
 * its last modification, that of its mapper, data with all blocks, attributes of blocks, lookup
 * table, textures and clipping planes included; the same of the volumes between them. Frames with
 * equal signatures have equal layers.
 */
class vtkOITFrameSignature
{
public:
  vtkOITFrameSignature() = default;
  /// `settings`: when the properties of the pass were changed last.
  vtkOITFrameSignature(const vtkOITFrame& frame, vtkMTimeType settings);

  /// False where a change could go unseen: props with shaders or uniforms of their own, mappers
  /// other than VTK's for polygons and composite data, blocks with lookup tables or textures of
  /// their own, textures of properties, textures without an image, stereo, shadows, image-based
  /// lighting, other passes that change shaders; volumes with several inputs, with shaders of
  /// their own, or whose samples depend on the time that frames take.
  bool IsKnown() const { return this->Known; }

  bool operator==(const vtkOITFrameSignature& other) const
  {
    return this->Known && other.Known && this->Numbers == other.Numbers;
  }

private:
  void Add(std::uint64_t number) { this->Numbers.push_back(number); }
  void Add(const void* address) { this->Add(reinterpret_cast<std::uintptr_t>(address)); }
  void AddDoubles(const double* values, int count);
  void AddView(const vtkOITFrame& frame);
  void AddLights(const vtkOITFrame& frame);
  void AddProps(const vtkOITFrame& frame);
  void AddBlocks(vtkMapper* mapper);
  void AddVolume(vtkProp* prop);

  std::vector<std::uint64_t> Numbers;
  bool Known = false;
};

#endif
