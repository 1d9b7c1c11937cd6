// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITIsCalled_h
#define vtkOITIsCalled_h

#include "vtkObjectBase.h"

#include <algorithm>
#include <cstring>
#include <iterator>

/// Whether an object is of this class and of none derived from it, which may draw in another way; false for
/// nullptr. Asked of each prop in each frame: without a string made of the name.
inline bool vtkOITIsCalled(vtkObjectBase* object, const char* name)
{
  return object && std::strcmp(object->GetClassName(), name) == 0;
}

/// The same for one of several classes, a range of const char*.
template <typename Names>
bool vtkOITIsCalledOneOf(vtkObjectBase* object, const Names& names)
{
  return std::any_of(std::begin(names), std::end(names),
    [object](const char* name) { return vtkOITIsCalled(object, name); });
}

#endif
