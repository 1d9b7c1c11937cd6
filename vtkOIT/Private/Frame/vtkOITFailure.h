// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITFailure_h
#define vtkOITFailure_h

#include "Private/Frame/vtkOITRectangle.h"

#include <string>
#include <utility>
#include <vector>

/**
 * Whether a step has failed, and why: one line that a user understands. Every step that can fail
 * returns one (an allocation, a framebuffer, a program), and the compiler warns where it is
 * ignored:
 *
 *   if (vtkOITFailure failure = this->Sums.Reserve(...)) { return failure; }
 */
class [[nodiscard]] vtkOITFailure
{
public:
  /// The step was done.
  vtkOITFailure() = default;
  /// It was not, for this reason.
  explicit vtkOITFailure(std::string reason)
    : Reason(std::move(reason))
  {
  }
  /// There was no memory on the context: a smaller part of the frame may fit.
  static vtkOITFailure OfMemory(std::string reason)
  {
    vtkOITFailure failure(std::move(reason));
    failure.Memory = true;
    return failure;
  }

  explicit operator bool() const { return !this->Reason.empty(); }
  const std::string& GetReason() const { return this->Reason; }
  bool IsOfMemory() const { return this->Memory; }

  /// Of an engine's Draw(): where nothing was drawn yet, so that another one can go on there.
  std::vector<vtkOITRectangle> Undrawn;

private:
  std::string Reason;
  bool Memory = false;
};

#endif
