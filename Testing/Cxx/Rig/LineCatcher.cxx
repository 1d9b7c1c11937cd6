// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Rig/LineCatcher.h"

#include "vtkObjectFactory.h"

#include <algorithm>

namespace vtkOITTest
{
namespace
{
/// What comes after "ERROR: In file, line N\nclass (address): ".
std::string WithoutPlace(const std::string& text)
{
  const std::size_t end = text.find("): ");
  return end == std::string::npos ? text : text.substr(end + 3);
}
}

//------------------------------------------------------------------------------
class LineCatcher::Window : public vtkOutputWindow
{
public:
  static Window* New();
  vtkTypeMacro(Window, vtkOutputWindow);

  void DisplayText(const char* text) override
  {
    const std::string line = WithoutPlace(text);
    if (std::find(this->Usual.begin(), this->Usual.end(), line) == this->Usual.end())
    {
      this->Texts.push_back(line);
    }
  }

  std::vector<std::string> Texts;
  std::vector<std::string> Usual;
};
vtkStandardNewMacro(LineCatcher::Window);

//------------------------------------------------------------------------------
LineCatcher::LineCatcher(const std::vector<std::string>& usual)
  : Previous(vtkOutputWindow::GetInstance())
  , Caught(vtkSmartPointer<Window>::New())
  , Verbosity(vtkLogger::GetCurrentVerbosityCutoff())
{
  this->Caught->Usual = usual;
  // What is caught is not printed: errors that a test wants are none of its own.
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkOutputWindow::SetInstance(this->Caught);
}

//------------------------------------------------------------------------------
LineCatcher::~LineCatcher()
{
  vtkLogger::SetStderrVerbosity(this->Verbosity);
  vtkOutputWindow::SetInstance(this->Previous);
}

//------------------------------------------------------------------------------
const std::vector<std::string>& LineCatcher::GetTexts() const
{
  return this->Caught->Texts;
}

//------------------------------------------------------------------------------
std::string LineCatcher::Describe() const
{
  std::string all;
  for (const std::string& text : this->Caught->Texts)
  {
    all += "\n  " + text.substr(0, 300);
  }
  return all;
}
}
