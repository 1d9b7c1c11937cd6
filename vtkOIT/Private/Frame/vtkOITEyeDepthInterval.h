// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITEyeDepthInterval_h
#define vtkOITEyeDepthInterval_h

struct vtkOITFrame;
class vtkShaderProgram;

/// The eye depths (distances from the camera along its view) that the props of a frame can have,
/// and what turns window depths into eye depths.
struct vtkOITEyeDepthInterval
{
  double Near = 0.0; // of the clipping range
  double Far = 1.0;
  double Nearest = 0.0; // of the props, inside the clipping range; Nearest < Farthest
  double Farthest = 1.0;
  bool IsParallel = false; // projection

  /// The clipping range where bounds do not limit a prop.
  static vtkOITEyeDepthInterval Find(const vtkOITFrame& frame);

  /// oitClippingRange, oitInterval and oitIsParallel, where they are used.
  void SetUniforms(vtkShaderProgram* program) const;
};

#endif
