// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITFragmentReadback_h
#define vtkOITFragmentReadback_h

#include <cstdint>
#include <string>
#include <vector>

class vtkFloatArray;
class vtkOITFragmentStore;
struct vtkOITABufferShaders;

/// Copies the lists of a fragment store to the CPU. The layout is that of
/// glsl/ABuffer/vtkOITABufferNodeFS.glsl.
class vtkOITFragmentReadback
{
public:
  vtkOITFragmentReadback(const vtkOITFragmentStore& store, const vtkOITABufferShaders& shaders)
    : Store(store)
    , Shaders(shaders)
  {
  }

  /// Fills the array with the store's current rectangle: tuples as
  /// vtkOITABufferPass::GetFragments() describes them. `isWhole`: the store holds all of the frame.
  /// `fragments`: nodes in use. Returns an empty string, or one line that says why the array is
  /// empty.
  std::string Read(bool isWhole, std::int64_t fragments, vtkFloatArray* array) const;

  /// Empties the array; the reason for a frame that has captured nothing.
  std::string Refuse(vtkFloatArray* array) const;

private:
  std::vector<std::uint32_t> ReadHeads() const;
  std::vector<std::uint32_t> ReadNodes(std::int64_t nodes) const;
  void Append(std::uint32_t node, const std::vector<std::uint32_t>& nodes, int x, int y,
    std::vector<float>& values) const;

  const vtkOITFragmentStore& Store;
  const vtkOITABufferShaders& Shaders;
};

#endif
