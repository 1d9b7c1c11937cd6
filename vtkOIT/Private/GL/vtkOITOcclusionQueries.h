// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITOcclusionQueries_h
#define vtkOITOcclusionQueries_h

#include "Private/Frame/vtkOITCompatibility.h"
#include "Private/GL/vtkOITContextObjects.h"

#include <cstdint>
#include <vector>

/// A numbered row of occlusion queries, which count the samples that pass between Begin and End.
class vtkOITOcclusionQueries : public vtkOITContextObjects
{
public:
  ~vtkOITOcclusionQueries() override { this->Release(); }

  void Begin(vtkOpenGLRenderWindow* window, std::size_t number);
  static void End();

  /// Whether the result can be had without waiting.
  bool IsAvailable(std::size_t number) const;
  /// The number of samples; waits for it.
  std::int64_t GetResult(std::size_t number) const;

private:
  void Delete() override;
  void Forget() override { this->Names.clear(); }

  std::vector<GLuint> Names;
};

#endif
