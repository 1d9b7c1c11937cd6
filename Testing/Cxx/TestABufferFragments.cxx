// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Reading back captured fragments: all of them, where and as they were drawn.

#include "Rig/Rig.h"

#include "vtkOITABufferPass.h"
#include "vtkOITPassFactory.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTestErrorObserver.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

using namespace vtkOITTest;

namespace
{
constexpr int Width = 20;
constexpr int Height = 12;

using Tuple = std::array<float, 7>;

std::vector<Tuple> GetTuples(vtkFloatArray* array)
{
  std::vector<Tuple> tuples(array->GetNumberOfTuples());
  for (std::size_t i = 0; i < tuples.size(); ++i)
  {
    array->GetTypedTuple(static_cast<vtkIdType>(i), tuples[i].data());
  }
  // Rows from below, pixels from the left, from near to far.
  std::sort(tuples.begin(), tuples.end(),
    [](const Tuple& a, const Tuple& b)
    { return std::tie(a[1], a[0], a[2]) < std::tie(b[1], b[0], b[2]); });
  return tuples;
}

/// The refusal comes with an error of this text, and leaves nothing in the array.
void CheckRefused(Report& report, vtkOITABufferPass* pass, const std::string& text)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  pass->AddObserver(vtkCommand::ErrorEvent, observer);
  vtkNew<vtkFloatArray> array;
  array->SetNumberOfTuples(3);
  report.Check(!pass->GetFragments(array), "fragments in spite of: " + text);
  report.Check(array->GetNumberOfTuples() == 0, "fragments are left in the array: " + text);
  report.Check(observer->GetErrorMessage().find(text) != std::string::npos,
    "another error than: " + text + ": " + observer->GetErrorMessage());
  pass->RemoveObserver(observer);
}

/// Three layers, the second over a part only, the third hidden in another part.
void CheckLayers(Report& report, Rig& rig, vtkOITABufferPass* pass, double tolerance)
{
  const std::array<Layer, 3> layers = { { { 0.25f, { 0.9f, 0.3f, 0.1f, 0.3f } },
    { 0.5f, { 0.2f, 0.7f, 0.6f, 1.0f / 3.0f } }, { 0.75f, { 0.0f, 1.0f, 6e-6f, 0.99f } } } };
  const PixelRectangle part = { 3.0, 2.0, 11.0, 9.0 };
  const PixelRectangle hidden = { 15.0, 0.0, 20.0, 12.0 };
  rig.AddQuad(layers[2]);
  rig.AddQuad(layers[0]);
  rig.AddQuad(layers[1], part);
  rig.AddQuad({ 0.625f, { 0.5f, 0.5f, 0.5f, 1.0f } }, hidden);
  rig.Render();
  rig.Render(); // the first frame may be drawn twice
  vtkNew<vtkFloatArray> array;
  report.Check(pass->GetFragments(array), "no fragments");
  report.Check(array->GetNumberOfComponents() == 7, "not seven components");
  const std::vector<Tuple> tuples = GetTuples(array);
  report.Check(static_cast<vtkTypeInt64>(tuples.size()) == pass->GetNumberOfFragments(),
    "not as many tuples as fragments: " + std::to_string(tuples.size()));

  std::size_t i = 0;
  bool isRight = true;
  double largest = 0.0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      for (std::size_t layer = 0; layer < layers.size(); ++layer)
      {
        if ((layer == 1 && !part.Contains(x, y)) || (layer == 2 && hidden.Contains(x, y)))
        {
          continue;
        }
        isRight = isRight && i < tuples.size() && tuples[i][0] == x && tuples[i][1] == y &&
          tuples[i][2] == layers[layer].Depth;
        for (int c = 0; isRight && c < 4; ++c)
        {
          const double error = std::abs(tuples[i][3 + c] - layers[layer].Color[c]);
          largest = std::max(largest, error);
        }
        ++i;
      }
    }
  }
  report.Check(isRight && i == tuples.size(), "a fragment is missing, or is at another place");
  report.Check(largest <= tolerance, "a colour is " + std::to_string(largest) + " off");
}
}

int TestABufferFragments(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::All,
    [](Report& report, const Setup& setup)
    {
      Rig rig(setup, Width, Height);
      auto* pass = vtkOITABufferPass::SafeDownCast(rig.Pass);
      CheckRefused(report, pass, "captured no fragments");
      // A half float has 11 bits.
      const double tolerance = setup.FragmentStorage == Storage::Half ? 1.0 / 4096.0 : 1e-7;
      CheckLayers(report, rig, pass, tolerance);

      // Of a window that is larger than what is covered, coincident fragments one by one.
      rig.RemoveProps();
      const PixelRectangle pixel = { 13.0, 7.0, 14.0, 8.0 };
      for (int i = 0; i < 40; ++i)
      {
        rig.AddQuad({ 0.5f, { 0.5f, 0.25f, 1.0f, (i + 1) / 64.0f } }, pixel);
      }
      rig.Render();
      vtkNew<vtkFloatArray> array;
      report.Check(pass->GetFragments(array), "no coincident fragments");
      double opacity = 0.0;
      for (const Tuple& tuple : GetTuples(array))
      {
        report.Check(tuple[0] == 13.0f && tuple[1] == 7.0f && tuple[2] == 0.5f &&
            tuple[3] == 0.5f && tuple[4] == 0.25f && tuple[5] == 1.0f,
          "a coincident fragment is not as it was drawn");
        opacity += tuple[6];
      }
      report.Check(array->GetNumberOfTuples() == 40 && opacity == 820.0 / 64.0,
        "coincident fragments are lost: " + std::to_string(array->GetNumberOfTuples()));

      rig.RemoveProps();
      rig.Render();
      if (setup.UseMode != Use::Installed) // a renderer with nothing translucent calls no pass
      {
        CheckRefused(report, pass, "captured no fragments");
      }

      // 164 thousand fragments of at least 12 bytes do not fit into 1 MiB.
      rig.SetSize(64, 64);
      for (int i = 0; i < 40; ++i)
      {
        rig.AddQuad({ (i + 1) / 64.0f, { 0.5f, 0.5f, 0.5f, 0.1f } });
      }
      rig.Pass->SetMaximumBufferSize(1 << 20);
      rig.Render();
      CheckRefused(report, pass, "in bands");
      rig.Pass->ReleaseGraphicsResources(rig.Window);
      CheckRefused(report, pass, "captured no fragments");
    });
}
