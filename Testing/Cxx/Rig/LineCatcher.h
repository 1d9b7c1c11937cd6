// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The errors and warnings that VTK's classes and ours give while it lives, instead of printing them.
 */

#ifndef LineCatcher_h
#define LineCatcher_h

#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace vtkOITTest
{
class LineCatcher
{
public:
  /// Those that are `usual` are not caught.
  explicit LineCatcher(const std::vector<std::string>& usual = {});
  ~LineCatcher();
  LineCatcher(const LineCatcher&) = delete;
  void operator=(const LineCatcher&) = delete;

  /// Without file, line, class and address.
  const std::vector<std::string>& GetTexts() const;
  /// All of them, for a message.
  std::string Describe() const;

private:
  class Window;
  vtkSmartPointer<vtkOutputWindow> Previous;
  vtkSmartPointer<Window> Caught;
  vtkLogger::Verbosity Verbosity;
};
}

#endif
