// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITAllocation_h
#define vtkOITAllocation_h

#include "Private/Frame/vtkOITCompatibility.h"
#include "Private/Frame/vtkOITFailure.h"

/**
 * Watches over the allocation of textures and buffers: tells whether GL had the memory, and keeps a
 * pixel buffer of the application from being read instead of nothing.
 *
 *   vtkOITAllocation allocation;
 *   glTexImage3D(...);
 *   return allocation.Check("a texture of 800 x 600 pixels");
 */
class vtkOITAllocation
{
public:
  vtkOITAllocation();
  ~vtkOITAllocation();
  vtkOITAllocation(const vtkOITAllocation&) = delete;
  vtkOITAllocation& operator=(const vtkOITAllocation&) = delete;

  /// `what` could not be allocated.
  vtkOITFailure Check(const std::string& what) const;

  /// Forgets errors of before; bounded, as a lost context has errors without end. True when one of
  /// them was that memory ran out.
  static bool TakeErrors();

private:
  GLint UnpackBuffer = 0;
};

#endif
