// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchmarkScenes_h
#define BenchmarkScenes_h

#include <string>
#include <vector>

class vtkRenderer;

/// A scene fills a renderer with translucent actors and places the camera.
struct BenchmarkScene
{
  std::string Name;
  std::string Description;
  void (*Fill)(vtkRenderer* renderer);
};

const std::vector<BenchmarkScene>& GetBenchmarkScenes();

#endif
