// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITHookRecord_h
#define vtkOITHookRecord_h

#include "vtkType.h" // for vtkTypeInt64

#include <memory>
#include <string>

/**
 * What became of a renderer, or of a pass, of an application that did not ask for vtkOIT: how it was
 * reached, and what its frames were. With the log on it says so on standard error in one line when
 * the first frame begins, and in one line at the end of the process.
 */
class vtkOITHookRecord
{
public:
  /// `way`: how it was reached, the end of "vtkRenderer reached ...". `method`: its name.
  static std::shared_ptr<vtkOITHookRecord> Create(
    const std::string& way, const std::string& method, bool respect, bool log);

  /// Whether the application's depth-peeling switch decides who draws.
  bool RespectsDepthPeeling() const { return this->Respect; }

  /// A frame begins; `obstacle`: empty, or why VTK draws it.
  void Begin(const char* rendererClass, const std::string& obstacle);

  /// It has ended.
  struct Frame
  {
    std::string Algorithm;
    bool Exact;
    int GeometryPasses;
    vtkTypeInt64 Fragments; // negative where not known
    int DepthComplexity;    // as well
  };
  void End(const Frame& frame);

  /// A line on standard error, after "vtkoit: ".
  static void Say(const std::string& line);

private:
  static void SayAll();
  std::string GetSummary() const;

  std::string Way;
  std::string Method;
  bool Respect = false;
  bool Log = false;
  std::string RendererClass;
  std::string Obstacle;
  int NumberOfFrames = 0;
  int NumberOfExactFrames = 0;
  Frame Last = {};
};

#endif
