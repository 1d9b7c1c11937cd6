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
  int Try(vtkProp* prop, vtkOITGather& gather) override;
  bool DrawUnsorted(const std::vector<vtkProp*>& props) override;
  bool TryUnsorted(vtkProp* prop) override;

  int GetNumberOfPasses() const { return this->NumberOfPasses; }
  int GetNumberOfRenderedProps() const { return static_cast<int>(this->Rendered.size()); }

private:
  vtkOITFailure DrawHooked(const std::vector<vtkProp*>& props, vtkOITGather& gather);
  bool Note(const std::vector<vtkProp*>& props);

  vtkRenderPass* Pass;
  const vtkRenderState* State;
  int NumberOfPasses = 0;
  std::set<vtkProp*> Rendered;
};

/// The props of the state that such a pass would draw as translucent.
std::vector<vtkProp*> vtkOITFindTranslucentProps(const vtkRenderState* state);

/// The visible props of the state that say that they have nothing translucent and yet may draw it:
/// all but plain actors, which keep their word. Representations of widgets are such props.
std::vector<vtkProp*> vtkOITFindDenyingProps(const vtkRenderState* state);

#endif
