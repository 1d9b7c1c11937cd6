// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITGeometry_h
#define vtkOITGeometry_h

#include "Private/Frame/vtkOITFailure.h"

#include <vector>

class vtkOITGather;
class vtkProp;

/// Draws props, whoever does it: what an engine knows of the rest of VTK's pipeline.
class vtkOITGeometry
{
public:
  virtual ~vtkOITGeometry() = default;

  /// One geometry pass over the props, into what is bound, under a gather. Fails when a program of
  /// a prop does not compile: then nothing of that prop is drawn.
  virtual vtkOITFailure Draw(const std::vector<vtkProp*>& props, vtkOITGather& gather) = 0;

  /// Draws a prop under a gather as Draw() does, but as a trial: it counts in no statistics. Returns
  /// the number of draws that asked the gather's hook.
  virtual int Try(vtkProp* prop, vtkOITGather& gather) = 0;

  /// The props as VTK draws them without any pass of ours, into what is bound and as it is set. True
  /// when one of them has drawn something.
  virtual bool DrawUnsorted(const std::vector<vtkProp*>& props) = 0;

  /// The same of one prop as a trial: it counts in no statistics.
  virtual bool TryUnsorted(vtkProp* prop) = 0;
};

#endif
