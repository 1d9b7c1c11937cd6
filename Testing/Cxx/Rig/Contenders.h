// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * VTK's own translucent passes in place of a method, and methods in the same place. The tests run
 * as they are, but nothing is asserted: the comparisons become lines of a file and pictures, of
 * which `vtkoit conform` makes its page.
 *
 *     vtk-weighted  vtkOrderIndependentTranslucentPass, VTK's default
 *     vtk-dual      vtkDualDepthPeelingPass, UseDepthPeelingOn(), as many peels as it wants
 *     vtk-dual-4    the same with 4 peels, as in ParaView
 *     vtk-peel      vtkDepthPeelingPass in a vtkRenderStepsPass, as many peels as it wants
 *     METHOD        a pass of vtkOIT as it is by default, where --results is given
 *
 * All of them draw into an 8-bit window without multisampling, with alpha planes. So the tolerance
 * of each comparison is widened by three steps of 255: rounding alone shall not be called wrong.
 */

#ifndef Contenders_h
#define Contenders_h

#include "Rig/Setup.h"

namespace vtkOITTest
{
/// Whether the name is that of a pass of VTK's.
bool IsContender(const std::string& name);

/// What stands behind an option of the command line; empty where it is not given.
std::string GetOption(int argc, char* argv[], const std::string& name);

/// What takes the place of a method's pass in the tests, nullptr for an unknown name; VTK's own do
/// not render it.
vtkSmartPointer<vtkOITPass> CreateContenderPass(const std::string& name);

/// Makes the renderer draw its translucent props by the contender; back to VTK's default.
///@{
void AttachContender(const std::string& name, vtkRenderer* renderer, vtkOITPass* pass);
void DetachContender(vtkRenderer* renderer);
///@}

/// RunTest() for a contender. `--results FILE` appends the comparisons to a file, a line of JSON
/// each, `--pictures FOLDER` keeps the pictures of small ones.
int RunContender(int argc, char* argv[], const std::function<void(Report&, const Setup&)>& body);

/// The body's comparisons for a contender; pictures: a folder, or empty for none.
std::vector<Report::Result> ObserveContender(const std::string& name,
  const std::function<void(Report&, const Setup&)>& body, const std::string& pictures = {});
}

#endif
