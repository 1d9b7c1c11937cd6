// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITReplacements_h
#define vtkOITReplacements_h

#include <string>

class vtkAbstractMapper;
class vtkProp;

/// What happens to the text of a mapper's fragment shader before and after the mapper itself replaces
/// the marks in it, and before a gather makes its stage of it.
class vtkOITReplacements
{
public:
  virtual ~vtkOITReplacements() = default;
  virtual void Before(
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) const = 0;
  virtual void After(std::string& fragmentShader) const = 0;
};

#endif
