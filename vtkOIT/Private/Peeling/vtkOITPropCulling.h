// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITPropCulling_h
#define vtkOITPropCulling_h

#include "Private/GL/vtkOITOcclusionQueries.h"

#include <array>
#include <unordered_map>
#include <vector>

class vtkProp;

/**
 * Leaves props out of geometry passes once nothing of them is left to peel.
 *
 * An occlusion query counts the fragments of each prop that the hardware's depth test against the
 * Mask lets pass. What the Mask rejects is peeled or belongs to finished pixels, so a prop without
 * fragments has none in later passes either. Results are read one pass late, if they are available.
 */
class vtkOITPropCulling
{
public:
  /// Starts a frame with all its props.
  void Begin(vtkOpenGLRenderWindow* window, const std::vector<vtkProp*>& props);

  /// Starts a geometry pass: the props to be drawn.
  std::vector<vtkProp*> BeginPass();
  /// A prop is about to be drawn; called once or several times in a row for each.
  void Draw(vtkProp* prop);
  void EndPass();

  void Release() { this->Queries.Release(); }

private:
  struct Entry
  {
    vtkProp* Prop = nullptr;
    bool IsDone = false;
    bool IsUnknown = false;        // drawn in a way that one query cannot count
    std::array<bool, 2> IsAsked{}; // in the pass before last, in the last pass
  };
  static constexpr std::size_t None = static_cast<std::size_t>(-1);

  void ReadResults(std::size_t slot);
  std::size_t GetNumber(std::size_t entry, std::size_t slot) const { return 2 * entry + slot; }

  vtkOITOcclusionQueries Queries;
  std::vector<Entry> Entries;
  std::unordered_map<vtkProp*, std::size_t> Index;
  std::size_t Slot = 0; // alternates from pass to pass
  std::size_t Current = None;
};

#endif
