// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITReadback_h
#define vtkOITReadback_h

#include "Private/Frame/vtkOITCompatibility.h"

#include <array>

/// While it lives, pixels are read into plain memory, one after the other: the pixel-store
/// parameters and the pack buffer of the application are set aside, and restored at its end.
class vtkOITReadback
{
public:
  vtkOITReadback();
  ~vtkOITReadback();
  vtkOITReadback(const vtkOITReadback&) = delete;
  vtkOITReadback& operator=(const vtkOITReadback&) = delete;

private:
  std::array<GLint, 8> Parameters{};
  GLint PackBuffer = 0;
};

#endif
