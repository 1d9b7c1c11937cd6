// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Frames of composite data are reused, too, and a change of a block's look, data or place is seen.

#include "Rig/Rig.h"

#include "Private/Frame/vtkOITCompatibility.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkLookupTable.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkOITAutoPass.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

using namespace vtkOITTest;

namespace
{
constexpr int Width = 48;
constexpr int Height = 36;
constexpr Tolerance LastBits{ 1e-6, 1e-6 }; // of a layer composited over a float32 framebuffer

vtkSmartPointer<vtkPolyData> MakeBall(double x)
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(x, 0.0, 0.0);
  source->SetThetaResolution(12);
  source->Update();
  vtkSmartPointer<vtkPolyData> ball = source->GetOutput();
  vtkNew<vtkFloatArray> values;
  for (vtkIdType i = 0; i < ball->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(static_cast<float>(std::abs(ball->GetPoint(i)[1])));
  }
  ball->GetPointData()->SetScalars(values);
  return ball;
}

/// A ball, and a block of two balls: flat indices 1, and 2 with 3 and 4.
struct BlockScene
{
  explicit BlockScene(Rig& rig)
    : Pass(vtkOITAutoPass::SafeDownCast(rig.Pass))
  {
    vtkNew<vtkMultiBlockDataSet> pair;
    pair->SetBlock(0, this->Ball);
    pair->SetBlock(1, MakeBall(0.5));
    this->Blocks->SetBlock(0, MakeBall(-0.5));
    this->Blocks->SetBlock(1, pair);
    this->Mapper->SetInputDataObject(this->Blocks);
    this->Mapper->SetCompositeDataDisplayAttributes(this->Attributes);
    this->Mapper->ScalarVisibilityOff();
    this->Colors->SetNumberOfTableValues(4);
    this->Colors->Build();
    this->Mapper->SetLookupTable(this->Colors);
    this->Mapper->SetScalarRange(0.0, 0.5);
    this->Actor->SetMapper(this->Mapper);
    this->Actor->GetProperty()->SetColor(0.8, 0.5, 0.2);
    this->Actor->GetProperty()->SetOpacity(0.5);
    rig.Renderer->AddActor(this->Actor);
    vtkCamera* camera = rig.Renderer->GetActiveCamera();
    camera->ParallelProjectionOff();
    camera->SetPosition(0.0, 0.4, 5.0);
    camera->SetClippingRange(2.0, 9.0);
  }

  vtkOITAutoPass* Pass;
  vtkSmartPointer<vtkPolyData> Ball = MakeBall(0.0);
  vtkNew<vtkMultiBlockDataSet> Blocks;
  vtkNew<vtkCompositeDataDisplayAttributes> Attributes;
  vtkNew<vtkLookupTable> Colors;
  vtkNew<vtkOITCompositeMapper> Mapper;
  vtkNew<vtkActor> Actor;
};

struct Change
{
  std::string Name;
  std::function<void(BlockScene&)> Do;
};

std::vector<Change> GetChanges()
{
  const double green[] = { 0.1, 0.9, 0.2 };
  return {
    { "colour of a block", [](BlockScene& s) { s.Mapper->SetBlockColor(1, 0.9, 0.1, 0.1); } },
    { "colour of a block, by its attributes",
      [green](BlockScene& s) { s.Attributes->SetBlockColor(s.Ball, green); } },
    { "colour of a block of blocks",
      [](BlockScene& s) { s.Mapper->SetBlockColor(2, 0.1, 0.1, 0.9); } },
    { "no colour of a block", [](BlockScene& s) { s.Mapper->RemoveBlockColor(1); } },
    { "opacity of a block", [](BlockScene& s) { s.Mapper->SetBlockOpacity(1, 0.9); } },
    { "block hidden", [](BlockScene& s) { s.Mapper->SetBlockVisibility(3, false); } },
    { "block shown", [](BlockScene& s) { s.Mapper->SetBlockVisibility(3, true); } },
    { "block of blocks hidden",
      [](BlockScene& s) { s.Attributes->SetBlockVisibility(s.Blocks->GetBlock(1), false); } },
    { "all blocks shown", [](BlockScene& s) { s.Mapper->RemoveBlockVisibilities(); } },
    { "points of a block",
      [](BlockScene& s)
      {
        auto* points = vtkFloatArray::SafeDownCast(s.Ball->GetPoints()->GetData());
        for (vtkIdType i = 0; i < points->GetNumberOfTuples(); ++i)
        {
          points->SetComponent(i, 1, 1.5 * points->GetComponent(i, 1));
        }
        points->Modified();
      } },
    { "another block", [](BlockScene& s) { s.Blocks->SetBlock(0, MakeBall(-0.8)); } },
    { "block removed", [](BlockScene& s) { s.Blocks->SetBlock(0, nullptr); } },
    { "no colours of blocks", [](BlockScene& s) { s.Attributes->RemoveBlockColors(); } },
    { "scalars", [](BlockScene& s) { s.Mapper->ScalarVisibilityOn(); } },
    { "values of a block, in place",
      [](BlockScene& s)
      {
        auto* values = vtkFloatArray::SafeDownCast(s.Ball->GetPointData()->GetScalars());
        values->FillValue(0.4f);
        values->Modified();
      } },
    { "entry of the lookup table",
      [](BlockScene& s) { s.Colors->SetTableValue(1, 0.1, 0.1, 0.9, 0.8); } },
    { "property", [](BlockScene& s) { s.Actor->GetProperty()->SetAmbient(0.5); } },
    { "other data",
      [](BlockScene& s)
      {
        vtkNew<vtkMultiBlockDataSet> blocks;
        blocks->SetBlock(0, MakeBall(0.2));
        s.Mapper->SetInputDataObject(blocks);
      } },
  };
}

double FindLargestDifference(const Image& a, const Image& b)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < a.Pixels.size(); ++i)
  {
    for (int channel = 0; channel < 4; ++channel)
    {
      largest = std::max<double>(largest, std::abs(a.Pixels[i][channel] - b.Pixels[i][channel]));
    }
  }
  return largest;
}
}

int TestAutoPassBlocks(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      Rig rig(setup, Width, Height);
      BlockScene scene(rig);
      const auto isReused = [&scene]
      { return scene.Pass->GetSkipSummary().find("whole frame reused") != std::string::npos; };
      rig.Render(); // makes default lookup tables, which is a change
      for (const Change& change : GetChanges())
      {
        rig.Render();
        rig.Render();
        const Image before = rig.Render();
        report.Check(isReused(), change.Name + ": the third still frame is not reused");
        change.Do(scene);
        const Image after = rig.Render();
        report.Check(!isReused(), change.Name + ": is not seen");
        report.Check(
          FindLargestDifference(before, after) > 1e-3, change.Name + ": changes nothing");
        scene.Pass->ReuseFramesOff();
        report.Compare(change.Name, after, rig.Render(), LastBits);
        scene.Pass->ReuseFramesOn();
      }
    });
}
