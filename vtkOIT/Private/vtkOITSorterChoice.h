// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITSorterChoice_h
#define vtkOITSorterChoice_h

#include "vtkSmartPointer.h"

#include <cstdint>
#include <functional>
#include <string>

class vtkOITFrame;
class vtkOITPass;
class vtkWindow;

/**
 * The exact method that sorts the fragments of a frame at the lowest price.
 *
 * Measured on llvmpipe and on every scene of the benchmark, that is the A-buffer as long as its
 * fragments fit into the memory. Beyond that it draws the scene once for each of its bands, and
 * multi-layer peeling once for each 8 layers of each of its own, so the smaller number decides.
 * What is needed is known from the last frame; a choice is changed only when the other one is a
 * quarter cheaper, so that frames do not alternate.
 */
class vtkOITSorterChoice
{
public:
  /// A pass for the frame, with the limit in bytes. `findMissing` says what a pass lacks for it.
  vtkOITPass& Choose(const vtkOITFrame& frame, std::int64_t limit,
    const std::function<std::string(vtkOITPass&)>& findMissing);

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
  bool IsPeelingCheaper(const vtkOITFrame& frame, std::int64_t limit) const;
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
  int DepthComplexity = 0;
};

#endif
