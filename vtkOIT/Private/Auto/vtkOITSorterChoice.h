// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITSorterChoice_h
#define vtkOITSorterChoice_h

#include "vtkSmartPointer.h"

#include <cstdint>
#include <functional>
#include <string>

class vtkOITPass;
class vtkWindow;

/**
 * The exact method that sorts the fragments of a frame at the lowest price.
 *
 * That is the A-buffer wherever it runs, also when its fragments do not fit into the memory: then
 * it draws the scene once for each of its bands, but each fragment in one of them only. Multi-layer
 * peeling has no fewer geometry passes: for N layers both need `area / limit` of them, times 216
 * ⌈N/8⌉ bytes instead of 16 N + 8, and it shades and sorts what is left in each. docs/costs.md has
 * what was measured. Without an A-buffer multi-layer peeling is the best, then dual depth peeling.
 */
class vtkOITSorterChoice
{
public:
  /// A pass for a frame, with the limit in bytes. `findMissing` says what a pass lacks for it.
  vtkOITPass& Choose(
    std::int64_t limit, const std::function<std::string(vtkOITPass&)>& findMissing);

  /// Why that pass.
  const std::string& GetReason() const { return this->Reason; }

  /// Remembers what the frame had, once the pass has drawn it.
  void Note(vtkOITPass& pass);

  /// Frees what passes hold that were not chosen: the limit is for all together.
  void ReleaseUnused(vtkWindow* window);

  /// Of all passes.
  std::int64_t GetSizeInBytes() const;
  void Release(vtkWindow* window);

private:
  vtkOITPass& Use(int which, std::int64_t limit, const std::string& reason);

  enum
  {
    ABuffer,
    MultiLayer,
    Dual,
    Count
  };
  vtkSmartPointer<vtkOITPass> Passes[Count]; // made when first needed
  int Current = ABuffer;
  std::string Reason;
  std::int64_t Fragments = 0; // of the last frame
};

#endif
