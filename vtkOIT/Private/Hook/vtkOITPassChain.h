// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITPassChain_h
#define vtkOITPassChain_h

#include "vtkSmartPointer.h"

#include <functional>
#include <vector>

class vtkRenderPass;

/**
 * Puts a pass into the translucent slots of a chain of VTK's own pass containers: where a
 * vtkRenderStepsPass, a sequence, a camera or an image-processing pass has one of VTK's translucent
 * passes. Gives each slot back what it had.
 */
class vtkOITPassChain
{
public:
  ~vtkOITPassChain() { this->GiveBack(); }

  /// Puts the pass into all slots of the chain that do not have it. True when it is in one of them
  /// then, whoever has put it there.
  bool Put(vtkRenderPass* chain, vtkRenderPass* pass);

  /// Whether the chain of the last Put() has a pass that lets the renderer draw by itself, as those of
  /// ParaView do: then its own slot for depth peeling is asked.
  bool LeadsToRenderer() const { return this->AsksRenderer; }

  /// The slots get back what they had.
  void GiveBack();

private:
  using Setter = std::function<void(vtkRenderPass*)>;
  void Visit(vtkRenderPass* chain, vtkRenderPass* pass, int depth);
  void Fill(vtkRenderPass* content, vtkRenderPass* pass, int depth, const Setter& set);

  struct Slot
  {
    vtkSmartPointer<vtkRenderPass> Before;
    Setter Set;
  };
  std::vector<Slot> Slots; // that were filled
  bool IsIn = false;
  bool AsksRenderer = false;
};

#endif
