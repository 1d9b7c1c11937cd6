// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * All kinds of changes to a ReuseScene, by what they change. They are made one after another.
 */

#ifndef ReuseChanges_h
#define ReuseChanges_h

#include <functional>
#include <string>
#include <vector>

namespace vtkOITTest
{
struct ReuseScene;

struct Change
{
  enum Kind
  {
    Seen,    // must be drawn anew
    Shown,   // the layer is reused, the picture is another one
    NotReady // not reused before the change either
  };
  std::string Name;
  std::function<void(ReuseScene&)> Do;
  Kind Is = Seen;
};

std::vector<Change> GetViewChanges();
std::vector<Change> GetPropChanges();
std::vector<Change> GetDataChanges();
std::vector<Change> GetLightChanges();
std::vector<Change> GetPassChanges();
}

#endif
