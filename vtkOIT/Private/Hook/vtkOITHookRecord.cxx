// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Hook/vtkOITHookRecord.h"

#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <sstream>
#include <vector>

namespace
{
/// Those that are logged. Never destroyed: the end of a process comes to it after static objects.
struct Logged
{
  std::mutex Mutex;
  std::vector<std::shared_ptr<vtkOITHookRecord>> Records;
};
Logged& GetLogged()
{
  static auto* logged = new Logged;
  return *logged;
}
}

//------------------------------------------------------------------------------
std::shared_ptr<vtkOITHookRecord> vtkOITHookRecord::Create(
  const std::string& way, const std::string& method, bool respect, bool log)
{
  auto record = std::make_shared<vtkOITHookRecord>();
  record->Way = way;
  record->Method = method;
  record->Respect = respect;
  record->Log = log;
  if (log)
  {
    Logged& logged = GetLogged();
    const std::lock_guard<std::mutex> lock(logged.Mutex);
    static const int registered = std::atexit(&vtkOITHookRecord::SayAll);
    (void)registered;
    logged.Records.push_back(record);
  }
  return record;
}

//------------------------------------------------------------------------------
void vtkOITHookRecord::Begin(const char* rendererClass, const std::string& obstacle)
{
  const bool isNew = this->RendererClass.empty() || this->Obstacle != obstacle;
  this->RendererClass = rendererClass;
  this->Obstacle = obstacle;
  if (this->Log && isNew)
  {
    Say(this->RendererClass + " reached " + this->Way + ", method " + this->Method +
      (obstacle.empty() ? "" : ", but does not draw: " + obstacle));
  }
}

//------------------------------------------------------------------------------
void vtkOITHookRecord::End(const Frame& frame)
{
  if (this->Obstacle.empty())
  {
    ++this->NumberOfFrames;
    this->NumberOfExactFrames += frame.Exact ? 1 : 0;
    this->Last = frame;
  }
}

//------------------------------------------------------------------------------
std::string vtkOITHookRecord::GetSummary() const
{
  std::ostringstream text;
  text << this->RendererClass << ": " << this->NumberOfFrames << " frames, "
       << this->NumberOfExactFrames << " exact";
  text << "; the last one by " << this->Last.Algorithm << ", " << this->Last.GeometryPasses
       << " geometry passes";
  if (this->Last.Fragments > 0)
  {
    text << ", " << this->Last.Fragments << " fragments";
  }
  if (this->Last.DepthComplexity > 0)
  {
    text << ", up to " << this->Last.DepthComplexity << " in a pixel";
  }
  return text.str();
}

//------------------------------------------------------------------------------
void vtkOITHookRecord::SayAll()
{
  Logged& logged = GetLogged();
  const std::lock_guard<std::mutex> lock(logged.Mutex);
  for (const auto& record : logged.Records)
  {
    if (record->NumberOfFrames > 0)
    {
      Say(record->GetSummary());
    }
  }
}

//------------------------------------------------------------------------------
void vtkOITHookRecord::Say(const std::string& line)
{
  std::fprintf(stderr, "vtkoit: %s\n", line.c_str());
}
