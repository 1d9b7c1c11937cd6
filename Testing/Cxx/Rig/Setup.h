// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a test is run for: a method, its properties and a way to use it.
 *
 * Tests are parametrised by method names (vtkOITPassFactory) on the command line, so a new method
 * is tested by adding its name to the list in CMakeLists.txt and its variants here.
 */

#ifndef Setup_h
#define Setup_h

#include "Rig/Layer.h"
#include "Rig/Report.h"

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

/// What the table in Setup.cxx promises of a method.
enum class Expectation
{
  Exact,  // within the rounding of its storage of fragments
  Preview // exact for one layer a pixel, and reported as not exact otherwise
};

struct Setup
{
  std::string Method;
  Expectation Promise = Expectation::Exact;
  Storage FragmentStorage = Storage::Half;
  Use UseMode = Use::Installed;
  std::string Tier = "all extensions"; // what the context is taken to have
  bool HasStorage = true;              // in this tier, so the A-buffer can take over
  bool HasFetch = true;                // in this tier
  bool HasInterlock = false;           // the fragment shader interlock, in this tier
  int LargestStack = 4096;             // layers that the method peels in bearable time
  bool IsContender = false;            // only observed, see Contenders.h
  /// The A-buffer compiles its sorting networks as soon as it could use them (VTKOIT_NETWORKS), so that
  /// tests of a few small frames test them; the automatic pass never does in tests.
  bool HasNetworksAtOnce = true;
  bool IsLong = false; // --long: also what takes too long to be run each time

  std::string Describe() const;

  /// A new pass of this method with this storage, without a TransmittanceThreshold; nullptr for an
  /// unknown method.
  vtkSmartPointer<vtkOITPass> CreatePass() const;

  /// Puts the pass into the renderer in this setup's way.
  void Attach(vtkRenderer* renderer, vtkOITPass* pass) const;

  /// Takes it out again.
  void Detach(vtkRenderer* renderer) const;
};

/// Which setups a test runs for.
enum class Setups
{
  All,     // every storage, every use; every tier, installed
  Storages // every storage and tier, installed: for what cannot depend on the way of use
};

/// Whether a part of a test is to be run: it is named behind the method, or no part is.
bool IsAsked(int argc, char* argv[], const std::string& part);

/// Runs the body for each setup of the method named on the command line (default: abuffer).
/// Returns the exit status: 125, with a line that names what is missing, when the method does not
/// run in this context. For a contender, and with `--results FILE`, nothing is asserted, see
/// RunContender(). `--long` sets Setup::IsLong.
int RunTest(
  int argc, char* argv[], Setups setups, const std::function<void(Report&, const Setup&)>& body);
}

#endif
