// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * VTK's own translucent passes in place of a method. The tests run as they are, but nothing is
 * asserted: the comparisons become lines of a file, of which Utilities/what_vtk_gets_wrong.py makes
 * docs/what-vtk-gets-wrong.md.
 *
 *     vtk-weighted  vtkOrderIndependentTranslucentPass, VTK's default
 *     vtk-dual      vtkDualDepthPeelingPass, UseDepthPeelingOn(), as many peels as it wants
 *     vtk-peel      vtkDepthPeelingPass in a vtkRenderStepsPass, as many peels as it wants
 *     control       vtkOITABufferPass, to test the tests: all of its comparisons must hold
 *
 * All of them draw into an 8-bit window without multisampling, with alpha planes. So the tolerance
 * of each comparison is widened by three steps of 255: rounding alone shall not be called wrong.
 */

#ifndef Contenders_h
#define Contenders_h

#include "Rig/Setup.h"

namespace vtkOITTest
{
bool IsContender(const std::string& name);

/// What takes the place of a method's pass in the tests; only control renders it.
vtkSmartPointer<vtkOITPass> CreateContenderPass();

/// Makes the renderer draw its translucent props by the contender; back to VTK's default.
///@{
void AttachContender(const std::string& name, vtkRenderer* renderer, vtkOITPass* pass);
void DetachContender(vtkRenderer* renderer);
///@}

/// RunTest() for a contender.
int RunContender(int argc, char* argv[], const std::function<void(Report&, const Setup&)>& body);

/// The body's comparisons for a contender.
std::vector<Report::Result> ObserveContender(
  const std::string& name, const std::function<void(Report&, const Setup&)>& body);
}

#endif
