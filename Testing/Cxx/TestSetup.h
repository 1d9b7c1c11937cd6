// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a test is run for: a method, its properties and a way to use it.
 *
 * Tests are parametrised by method names (vtkOITPassFactory) on the command line, so a new method
 * is tested by adding its name to the list in CMakeLists.txt and its variants here.
 */

#ifndef TestSetup_h
#define TestSetup_h

#include "ReferenceCompositor.h"
#include "TestReport.h"

#include "vtkOITPass.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkRenderer;

namespace vtkOITTest
{
/// The three ways to put a pass into a renderer.
enum class Use
{
  Installed,   // vtkOITRendererHook::Install(): the renderer's own pipeline around it
  RenderSteps, // vtkRenderStepsPass::SetTranslucentPass() given to vtkRenderer::SetPass()
  CameraChain  // a sequence of lights, opaque, ours, volumetric, overlay in a vtkCameraPass
};

struct Setup
{
  std::string Method;
  Storage FragmentStorage = Storage::Half;
  Use UseMode = Use::Installed;

  std::string Describe() const;

  /// A new pass of this method with this storage; nullptr for an unknown method.
  vtkSmartPointer<vtkOITPass> CreatePass() const;

  /// Puts the pass into the renderer in this setup's way.
  void Attach(vtkRenderer* renderer, vtkOITPass* pass) const;

  /// Takes it out again.
  void Detach(vtkRenderer* renderer) const;
};

/// Which setups a test runs for.
enum class Setups
{
  All,     // every storage, every use
  Storages // every storage, installed: for what cannot depend on the way of use
};

/// Runs the body for each setup of the method named on the command line (default: abuffer).
/// Returns the exit status: 125, with a line that names what is missing, when the method does not
/// run in this context.
int RunTest(int argc, char* argv[], Setups setups,
  const std::function<void(TestReport&, const Setup&)>& body);
}

#endif
