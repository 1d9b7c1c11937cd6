// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITStatistics_h
#define vtkOITStatistics_h

#include <algorithm>
#include <cstdint>
#include <string>

/// What a frame, or a part of it, says about itself. Their meaning is that of the getters of
/// vtkOITPass and vtkOITPeelingPass.
struct vtkOITStatistics
{
  int NumberOfRenderedProps = 0;
  int NumberOfGeometryPasses = 0;
  std::int64_t NumberOfFragments = 0; // negative: nobody has counted
  int MaximumDepthComplexity = 0;     // negative: nobody has counted
  bool Exact = true;
  double ErrorBound = 0.0;
  int NumberOfPeels = 0;
  std::int64_t NumberOfLostFragments = 0;
  bool SkippedHiddenFragments = false;
  std::int64_t SharedAllocations = 0; // of an A-buffer
  std::string Algorithm;              // that drew; empty: none
  std::string Reason;                 // why that one
  std::string Summary;                // what was skipped, and why; empty: nothing
  std::string Warning; // that another method draws, and why, one line; empty: none does
  std::string Fault;   // what is wrong with the picture, one line; empty: nothing

  /// Not exact, with this bound on the error of a colour.
  void NoteError(double bound)
  {
    this->Exact = this->Exact && bound == 0.0;
    this->ErrorBound = std::max(this->ErrorBound, bound);
  }
  /// The same of what was drawn over or under that.
  void AddError(double bound) { this->NoteError(std::min(1.0, this->ErrorBound + bound)); }
  void AddToSummary(const std::string& what)
  {
    this->Summary += (this->Summary.empty() ? "" : "; ") + what;
  }
  /// Not exact, and why; the first such line is kept.
  void NoteWarning(const std::string& warning)
  {
    this->Warning = this->Warning.empty() ? warning : this->Warning;
    this->NoteError(1.0);
  }
  /// Something is wrong with the picture; the first such line is kept.
  void NoteFault(const std::string& fault)
  {
    this->Fault = this->Fault.empty() ? fault : this->Fault;
    this->NoteError(1.0);
  }
  /// Props were blended without sorting, such as one of this class.
  void NoteUnsorted(const std::string& className)
  {
    this->Warning = "Props that cannot be sorted are blended as a whole, such as a " + className;
    this->NoteError(1.0);
  }
  /// What was drawn over that. Nobody has counted the fragments of a pixel in both.
  void Add(const vtkOITStatistics& part)
  {
    const bool isFirst = this->Algorithm.empty();
    const bool isCounted = this->NumberOfFragments >= 0 && part.NumberOfFragments >= 0;
    if (!part.Algorithm.empty())
    {
      this->NumberOfFragments = isCounted ? this->NumberOfFragments + part.NumberOfFragments : -1;
      this->MaximumDepthComplexity = isFirst ? part.MaximumDepthComplexity : -1;
      this->Algorithm = part.Algorithm;
      this->Reason = part.Reason;
    }
    this->NumberOfPeels += part.NumberOfPeels;
    this->NumberOfLostFragments += part.NumberOfLostFragments;
    this->SharedAllocations += part.SharedAllocations;
    this->SkippedHiddenFragments = this->SkippedHiddenFragments || part.SkippedHiddenFragments;
    this->AddError(part.ErrorBound);
    this->Exact = this->Exact && part.Exact;
    if (!part.Summary.empty())
    {
      this->AddToSummary(part.Summary);
    }
    this->Warning = this->Warning.empty() ? part.Warning : this->Warning;
    this->Fault = this->Fault.empty() ? part.Fault : this->Fault;
  }
  void NoteFragments(std::int64_t fragments, int depthComplexity)
  {
    this->NumberOfFragments += fragments;
    this->MaximumDepthComplexity = std::max(this->MaximumDepthComplexity, depthComplexity);
  }
};

#endif
