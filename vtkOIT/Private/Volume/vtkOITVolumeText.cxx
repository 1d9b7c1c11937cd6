// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Volume/vtkOITVolumeText.h"

#include "vtkOITVolumeDeclareFS.h"
#include "vtkOITVolumeMarchFS.h"

#include "glsl/Common/vtkOITConstants.h"

#include "vtkVolumeMapper.h"

#include <algorithm>
#include <array>

namespace
{
constexpr const char* Main = "void main()";

/// A mark of the mapper's shader, and what is added before or after it.
struct Addition
{
  const char* Mark;
  std::string Before;
  std::string After;
};

int FindMode(int blendMode)
{
  switch (blendMode)
  {
    case vtkVolumeMapper::COMPOSITE_BLEND:
    case vtkVolumeMapper::ISOSURFACE_BLEND:
      return OIT_VOLUME_MARCHED;
    case vtkVolumeMapper::SLICE_BLEND:
      return OIT_VOLUME_SLICE;
    default:
      return OIT_VOLUME_PROJECTED;
  }
}
}

//------------------------------------------------------------------------------
// The mapper's main() is cut off: what it calls is called by that of March.
bool vtkOITAddMarch(std::string& fragmentShader, int blendMode)
{
  const bool hasIsosurfaces = blendMode == vtkVolumeMapper::ISOSURFACE_BLEND;
  std::string declarations = "#define OIT_VOLUME_MODE " + std::to_string(FindMode(blendMode)) + "\n";
  declarations += hasIsosurfaces ? "#define OIT_ISOSURFACES\n" : "";
  const std::array<Addition, 3> additions = { {
    { "//VTK::DepthPeeling::Dec", declarations + vtkOITVolumeDeclareFS, "" },
    { "//VTK::Base::Impl",
      hasIsosurfaces ? "oitBefore = g_fragColor;\n    l_initialIndex = oitInterval;\n    "
                     : "oitBefore = g_fragColor;\n    ",
      "" },
    { "//VTK::Terminate::Impl", hasIsosurfaces ? "oitInterval = l_initialIndex;\n    " : "",
      "\n    if (g_currentT >= oitLimit) { break; }" },
  } };
  const std::size_t main = fragmentShader.rfind(Main);
  const bool hasAll = main != std::string::npos &&
    fragmentShader.find("//VTK::CallWorker::Impl", main) != std::string::npos &&
    std::all_of(additions.begin(), additions.end(),
      [&](const Addition& addition)
      { return fragmentShader.find(addition.Mark) < main; });
  if (!hasAll)
  {
    return false;
  }
  fragmentShader.erase(main);
  for (const Addition& addition : additions)
  {
    const std::string mark = addition.Mark;
    const std::size_t at = fragmentShader.find(mark);
    fragmentShader.insert(at + mark.size(), addition.After);
    fragmentShader.insert(at, addition.Before);
  }
  fragmentShader += vtkOITVolumeMarchFS;
  return true;
}

//------------------------------------------------------------------------------
std::string vtkOITGetMarchText()
{
  return std::string("//VTK::System::Dec\n") + vtkOITVolumeDeclareFS + vtkOITVolumeMarchFS;
}
