// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITReached_h
#define vtkOITReached_h

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <mutex>
#include <vector>

/**
 * The renderers or windows of an application that were reached. It owns them, and may remove observers
 * of theirs, so each may be gone.
 */
template <typename ClassType>
class vtkOITReached
{
public:
  /// At most once.
  void Add(ClassType* object)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Objects.erase(std::remove_if(this->Objects.begin(), this->Objects.end(),
                          [object](ClassType* each) { return !each || each == object; }),
      this->Objects.end());
    this->Objects.emplace_back(object);
  }

  /// Those that there are.
  std::vector<vtkSmartPointer<ClassType>> GetAll()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    std::vector<vtkSmartPointer<ClassType>> all;
    for (ClassType* object : this->Objects)
    {
      if (object)
      {
        all.emplace_back(object);
      }
    }
    return all;
  }

private:
  std::mutex Mutex;
  std::vector<vtkWeakPointer<ClassType>> Objects;
};

#endif
