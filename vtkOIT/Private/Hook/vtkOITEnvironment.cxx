// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Hook/vtkOITEnvironment.h"

#include <cstdlib>

namespace
{
std::string Get(const char* name, const char* byDefault)
{
  const char* value = std::getenv(name);
  return value && *value ? value : byDefault;
}
}

//------------------------------------------------------------------------------
vtkOITEnvironment vtkOITEnvironment::Read()
{
  vtkOITEnvironment result;
  const std::string autoload = Get("VTKOIT_AUTOLOAD", "1");
  const std::string log = Get("VTKOIT_LOG", "0");
  result.On = autoload != "0";
  result.Respect = autoload == "respect";
  result.Log = log == "1";
  result.Method = Get("VTKOIT_METHOD", "auto");
  if (autoload != "0" && autoload != "1" && !result.Respect)
  {
    result.Error = "VTKOIT_AUTOLOAD=" + autoload +
      " is not known; give 1 (on), respect (where depth peeling is on) or 0 (off)";
  }
  else if (log != "0" && log != "1")
  {
    result.Error = "VTKOIT_LOG=" + log + " is not known; give 1 (on) or 0 (off)";
  }
  if (!result.Error.empty())
  {
    result.On = false;
  }
  return result;
}
