// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITOcclusionQueries_h
#define vtkOITOcclusionQueries_h

#include "Private/Frame/vtkOITCompatibility.h"
#include "Private/GL/vtkOITContextObjects.h"

#include <cstdint>
#include <vector>

/// A numbered row of occlusion queries, which count the samples that pass between Begin and End.
/// Where the context does not count, or the application counts itself around the frame, nothing is
/// counted and nobody may rely on a result. That is found out once for a row: asking OpenGL for
/// every one of many props would wait for the driver. Errors are asked for at each query, as VTK 9.6
/// does at each change of the state. The names of a row are new, so a query that was never begun has no result.
class vtkOITOcclusionQueries : public vtkOITContextObjects
{
public:
  ~vtkOITOcclusionQueries() override { this->Release(); }

  /// Whether the context counts samples, and nobody else has begun to.
  static bool CanCount();

  /// Starts a row: at least once a frame.
  void StartRow(vtkOpenGLRenderWindow* window);
  void Begin(std::size_t number);
  void End();

  /// Whether the result can be had without waiting.
  bool IsAvailable(std::size_t number) const;
  /// The number of samples; waits for it. Negative when it is not known.
  std::int64_t GetResult(std::size_t number) const;
  /// Whether a result of this row was asked for that is not there although the context counts.
  bool HasFailed() const { return this->Failed; }

private:
  void Delete() override;
  void Forget() override { this->Names.clear(); }

  std::vector<GLuint> Names;
  bool Counts = true;
  mutable bool Failed = false;
};

#endif
