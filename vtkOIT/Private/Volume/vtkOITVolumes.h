// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITVolumes_h
#define vtkOITVolumes_h

#include "Private/Frame/vtkOITFailure.h"

#include <set>
#include <string>
#include <vector>

class vtkGPUVolumeRayCastMapper;
class vtkOITVolumeGather;
class vtkProp;
class vtkRenderPass;
class vtkRenderState;
class vtkVolume;

/// Draws the volumes of a frame: before the translucent props, between them, and after them. What an
/// engine knows of volumes.
class vtkOITVolumes
{
public:
  /// `pass` draws volumes of the renderer, framebuffer and required keys of the state; nullptr when
  /// they are not ours to draw.
  vtkOITVolumes(vtkRenderPass* pass, const vtkRenderState* state);
  bool CanDraw() const { return this->Pass != nullptr; }

  /// The visible props of the state that have volumes which are drawn to the screen.
  const std::vector<vtkProp*>& GetAll() const { return this->All; }

  /// When they are drawn, each part back to front. Default: all after the translucent props.
  void SetOrder(
    std::vector<vtkProp*> before, std::vector<vtkProp*> between, std::vector<vtkProp*> after);
  const std::vector<vtkProp*>& GetBetween() const { return this->Between; }
  void DrawBefore() { this->DrawPlainly(this->Before); }
  /// And all props that have no volumes and may yet draw something with them.
  void DrawAfter();

  /// Whether a single ray of each pixel takes all of a list: one volume in one part.
  bool IsAlone() const;

  /// Draws those under a gather into what is bound. Where that fails, the volume is not drawn, and is
  /// among those of GetFailed().
  vtkOITFailure Draw(vtkOITVolumeGather& gather);
  /// Fails for all of them.
  vtkOITFailure Refuse(const std::string& reason);
  const std::vector<vtkProp*>& GetFailed() const { return this->Failed; }

  /// As VTK draws them without any pass of ours, into what is bound and as it is set.
  void DrawPlainly(const std::vector<vtkProp*>& props);

  int GetNumberOfRenderedProps() const
  {
    return static_cast<int>(this->Rendered.size()) + this->RenderedOthers;
  }

private:
  vtkRenderPass* Pass;
  const vtkRenderState* State;
  std::vector<vtkProp*> All;
  std::vector<vtkProp*> Before;
  std::vector<vtkProp*> Between;
  std::vector<vtkProp*> After;
  std::vector<vtkProp*> Failed; // of the last Draw()
  std::set<vtkProp*> Rendered;
  int RenderedOthers = 0;
};

/// The mapper for GPUs that draws the volume, or nullptr.
vtkGPUVolumeRayCastMapper* vtkOITFindGPUMapper(vtkVolume* volume);

/// Whether the mappers of a prop's volumes ask our hooks: those for GPUs do.
bool vtkOITIsHookedVolume(vtkProp* prop);

#endif
