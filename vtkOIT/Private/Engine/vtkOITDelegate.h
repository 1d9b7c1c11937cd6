// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITDelegate_h
#define vtkOITDelegate_h

#include "Private/Engine/vtkOITGeometry.h"

#include <set>

class vtkRenderPass;
class vtkRenderState;

/// Draws props by a render pass, for a frame; counts how often, and which.
class vtkOITDelegate : public vtkOITGeometry
{
public:
  /// `state`: whose renderer, framebuffer and required keys the pass gets.
  vtkOITDelegate(vtkRenderPass* pass, const vtkRenderState* state)
    : Pass(pass)
    , State(state)
  {
  }

  vtkOITFailure Draw(const std::vector<vtkProp*>& props, vtkOITGather& gather) override;
  void DrawUnsorted(const std::vector<vtkProp*>& props) override;

  int GetNumberOfPasses() const { return this->NumberOfPasses; }
  int GetNumberOfRenderedProps() const { return static_cast<int>(this->Rendered.size()); }

  /// The props that were drawn under a gather without a call of its hook: they have nothing to draw,
  /// or draw parts that did not get their property keys, past the gather.
  const std::set<vtkProp*>& GetUngatheredProps() const { return this->Ungathered; }

private:
  void Note(const std::vector<vtkProp*>& props);

  vtkRenderPass* Pass;
  const vtkRenderState* State;
  int NumberOfPasses = 0;
  std::set<vtkProp*> Rendered;
  std::set<vtkProp*> Ungathered;
};

/// The props of the state that such a pass would draw as translucent.
std::vector<vtkProp*> vtkOITFindTranslucentProps(const vtkRenderState* state);

#endif
