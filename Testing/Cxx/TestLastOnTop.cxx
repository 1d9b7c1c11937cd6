// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Stress test 37: with CoincidentLayers LAST_ON_TOP fragments of equal depth are blended over each
// other in the order of drawing, of props and of the triangles of a mesh: as if each lay a little
// nearer than those drawn before it.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"
#include "Scenes/Meshes.h"
#include "Scenes/Random.h"

#include "Private/Frame/vtkOITCompatibility.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace vtkOITTest;

namespace
{
/// The layers with those drawn later a little nearer, in double precision's sense of "nearer".
std::vector<Layer> Unfold(const std::vector<Layer>& layers)
{
  std::vector<Layer> unfolded = layers;
  for (std::size_t i = 0; i < layers.size(); ++i)
  {
    unfolded[i].Depth -= 1e-6f * static_cast<float>(i);
  }
  return unfolded;
}

/// Dual depth peeling rounds the colour of a group once more with each fragment that joins it.
Tolerance FindBound(const Rig& rig, const Setup& setup, const std::vector<Layer>& layers)
{
  Tolerance bound =
    ReferenceCompositor::RoundingBound(Unfold(layers), rig.GetBackground(), setup.FragmentStorage);
  if (setup.FragmentStorage == Storage::Half)
  {
    bound.Color += std::ldexp(static_cast<double>(layers.size()), -11);
  }
  return bound;
}

void Compare(Report& report, Rig& rig, const Setup& setup, const std::string& what,
  const std::vector<Layer>& layers)
{
  const glm::dvec4 answer = ReferenceCompositor::Composite(Unfold(layers), rig.GetBackground());
  report.Compare(what, rig.Render(), Everywhere(answer), FindBound(rig, setup, layers));
  report.Check(rig.Pass->GetExact(), what + ": it is said not to be exact");
}

/// Two or three coincident actors, others in front and behind, in every draw order.
void CheckOrders(Report& report, Rig& rig, const Setup& setup, const std::vector<Layer>& layers)
{
  std::vector<int> order(layers.size());
  std::iota(order.begin(), order.end(), 0);
  do
  {
    std::vector<Layer> drawn;
    std::string what = std::to_string(layers.size()) + " layers, draw order ";
    for (const int index : order)
    {
      drawn.push_back(layers[index]);
      what += std::to_string(index);
    }
    rig.RemoveProps();
    rig.AddStack(drawn);
    Compare(report, rig, setup, what, drawn);
  } while (std::next_permutation(order.begin(), order.end()));
}

void CheckActors(Report& report, Rig& rig, const Setup& setup)
{
  const Layer front{ 0.25f, { 0.2f, 0.9f, 0.1f, 0.3f } };
  const Layer behind{ 0.75f, { 0.9f, 0.9f, 0.1f, 0.6f } };
  const Layer red{ 0.5f, { 1.0f, 0.0f, 0.0f, 0.5f } };
  const Layer green{ 0.5f, { 0.0f, 1.0f, 0.0f, 0.25f } };
  const Layer blue{ 0.5f, { 0.0f, 0.0f, 1.0f, 0.75f } };
  const Layer solid{ 0.5f, { 0.25f, 0.5f, 0.75f, 1.0f } };
  const Layer faint{ 0.5f, { 1.0f, 1.0f, 1.0f, 1.0f / 255.0f } };
  CheckOrders(report, rig, setup, { front, red, green, behind });
  CheckOrders(report, rig, setup, { front, solid, faint, behind });
  if (setup.UseMode == Use::Installed)
  {
    CheckOrders(report, rig, setup, { front, red, green, blue, behind });
    CheckOrders(report, rig, setup, { blue, solid, green, behind });
  }
}

/// More than a peel, or the registers of a stage, take at once; other layers are drawn between them.
void CheckManyActors(Report& report, Rig& rig, const Setup& setup)
{
  for (const int count : { 9, 20, 40 })
  {
    Random random(count);
    std::vector<Layer> layers = random.Layers(count + 6);
    for (int i = 0; i < count; ++i)
    {
      layers[i].Depth = 0.5f;
      layers[i].Color.a *= 0.25f;
    }
    random.Shuffle(layers);
    rig.RemoveProps();
    rig.AddStack(layers);
    Compare(report, rig, setup, std::to_string(count) + " coincident among others", layers);
  }
}

/// The faces of one mesh, each of a colour of its own.
vtkSmartPointer<vtkPolyData> MakeFaces(const Rig& rig, const std::vector<Layer>& layers)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(4);
  const PixelRectangle all = rig.GetFullRectangle();
  for (const Layer& layer : layers)
  {
    const double corners[4][2] = { { all.X0, all.Y0 }, { all.X1, all.Y0 }, { all.X1, all.Y1 },
      { all.X0, all.Y1 } };
    quads->InsertNextCell(4);
    for (const double* corner : corners)
    {
      const glm::dvec3 point = rig.ToWorld(corner[0], corner[1], layer.Depth);
      quads->InsertCellPoint(points->InsertNextPoint(point.x, point.y, point.z));
    }
    const glm::dvec4 color = glm::dvec4(layer.Color) * 255.0;
    colors->InsertNextTuple4(color.r, color.g, color.b, color.a);
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(quads);
  mesh->GetCellData()->SetScalars(colors);
  return mesh;
}

void AddFaces(Rig& rig, const std::vector<Layer>& layers)
{
  rig.RemoveProps();
  rig.AddPolyData(MakeFaces(rig, layers), { 1.0f, 1.0f, 1.0f, 1.0f });
}

void CheckFaces(Report& report, Rig& rig, const Setup& setup)
{
  std::vector<Layer> layers = Random(7).Layers(12);
  for (std::size_t i = 0; i < layers.size(); ++i)
  {
    layers[i].Depth = i % 4 == 3 ? layers[i].Depth : 0.5f;
    for (int channel = 0; channel < 4; ++channel)
    {
      layers[i].Color[channel] = std::round(layers[i].Color[channel] * 255.0f) / 255.0f;
    }
  }
  AddFaces(rig, layers);
  Compare(report, rig, setup, "faces of a mesh", layers);
  std::reverse(layers.begin(), layers.end());
  AddFaces(rig, layers);
  Compare(report, rig, setup, "faces of a mesh, reversed", layers);
}

/// Coincident blocks, which one mapper draws one by one, in the order of their addresses: one of them
/// lies on the other, or it is not promised.
void CheckBlocks(Report& report, Rig& rig, const Setup& setup, const Tolerance& added)
{
  const std::vector<Layer> blocks[2] = {
    { { 0.5f, { 1.0f, 0.0f, 0.0f, 0.6f } } },
    { { 0.75f, { 0.0f, 0.0f, 1.0f, 0.6f } }, { 0.5f, { 0.0f, 1.0f, 0.0f, 0.6f } } },
  };
  vtkNew<vtkMultiBlockDataSet> data;
  data->SetBlock(0, MakeFaces(rig, blocks[0]));
  data->SetBlock(1, MakeFaces(rig, blocks[1]));
  vtkNew<vtkOITCompositeMapper> mapper;
  mapper->SetInputDataObject(data);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->ForceTranslucentOn();
  rig.RemoveProps();
  rig.Renderer->AddActor(actor);
  const bool hasSamples = rig.Window->GetMultiSamples() > 0;
  const Image image = hasSamples ? rig.RenderWindow() : rig.Render();
  const bool isFirstOnTop = image.At(0, 0).r > image.At(0, 0).g;
  std::vector<Layer> layers = blocks[isFirstOnTop ? 1 : 0];
  const std::vector<Layer>& last = blocks[isFirstOnTop ? 0 : 1];
  layers.insert(layers.end(), last.begin(), last.end());
  if (rig.Pass->GetExact())
  {
    report.Compare("blocks", image,
      Everywhere(ReferenceCompositor::Composite(Unfold(layers), rig.GetBackground())),
      FindBound(rig, setup, layers) + added);
  }
  report.Check(rig.Pass->GetExact() || hasSamples, "blocks: they are said not to be exact");
}

/// An overlay with the vertices of the surface: both together are a surface of the blended colour.
void CheckOverlay(Report& report, Rig& rig, const Setup& setup)
{
  const glm::vec4 below(0.9f, 0.3f, 0.1f, 0.5f);
  const glm::vec4 above(0.1f, 0.4f, 0.9f, 0.25f);
  const float opacity = above.a + (1.0f - above.a) * below.a;
  const auto mesh = MakePolyData(MakeSphere({ 0.0, 0.0, 0.0 }, 0.7, 12, below));
  const auto blend = [&](const glm::vec4& first, const glm::vec4& last)
  {
    glm::vec4 color = (last * last.a + first * (first.a * (1.0f - last.a))) / opacity;
    color.a = opacity;
    return color;
  };
  const Tolerance bound = ReferenceCompositor::RoundingBoundOfAnyStack(8, setup.FragmentStorage);
  for (const bool isReversed : { false, true })
  {
    rig.RemoveProps();
    rig.AddPolyData(mesh, isReversed ? above : below);
    rig.AddPolyData(mesh, isReversed ? below : above);
    const Image both = rig.Render();
    rig.RemoveProps();
    rig.AddPolyData(mesh, isReversed ? blend(above, below) : blend(below, above));
    report.Compare(isReversed ? "surface over its overlay" : "overlay on its surface", both,
      rig.Render(), bound + bound);
  }
}

/// So little memory that the frame is drawn in bands.
void CheckBands(Report& report, const Setup& setup)
{
  Rig rig(setup, 160, 120);
  rig.Pass->SetCoincidentLayersToLastOnTop();
  rig.Pass->SetMaximumBufferSize(1 << 20);
  std::vector<Layer> layers = Random(5).Layers(9);
  for (const int i : { 1, 4, 5, 7 })
  {
    layers[i].Depth = 0.5f;
  }
  rig.AddStack(layers);
  Compare(report, rig, setup, "in bands", layers);
}

/// In a multisampled window, where the A-buffer draws for all.
void CheckSamples(Report& report, const Setup& setup)
{
  Rig rig(setup, 20, 16);
  rig.Pass->SetCoincidentLayersToLastOnTop();
  rig.Window->SetMultiSamples(4);
  for (const int count : { 3, 40 })
  {
    std::vector<Layer> layers = Random(count).Layers(count);
    for (int i = 0; i < count; i += 2)
    {
      layers[i].Depth = 0.5f;
    }
    rig.RemoveProps();
    rig.AddStack(layers);
    report.Compare(std::to_string(count) + " layers of 4 samples", rig.RenderWindow(),
      Everywhere(ReferenceCompositor::Composite(Unfold(layers), rig.GetBackground())),
      FindBound(rig, setup, layers) + Rig::WindowTolerance());
    report.Check(rig.Pass->GetExact(), "4 samples: it is said not to be exact");
  }
  CheckBlocks(report, rig, setup, Rig::WindowTolerance());
}

void CheckAll(Report& report, const Setup& setup)
{
  Rig rig(setup, 20, 16);
  rig.Pass->SetCoincidentLayersToLastOnTop();
  CheckActors(report, rig, setup);
  CheckManyActors(report, rig, setup);
  CheckFaces(report, rig, setup);
  CheckBlocks(report, rig, setup, {});
  CheckOverlay(report, rig, setup);
}

/// A context that cannot keep the order of coincident fragments: no promise, and the default is as it
/// was.
void CheckRefusal(Report& report, const Setup& setup)
{
  Rig rig(setup, 20, 16);
  const std::vector<Layer> layers{ { 0.5f, { 1.0f, 0.0f, 0.0f, 0.5f } },
    { 0.5f, { 0.0f, 1.0f, 0.0f, 0.25f } } };
  rig.AddStack(layers);
  rig.Render();
  report.Check(rig.Pass->GetExact(), "the mean is not exact");
  rig.Pass->SetCoincidentLayersToLastOnTop();
  report.Check(
    rig.Pass->GetMissingCapability(rig.GetGLWindow()).find("LAST_ON_TOP") != std::string::npos,
    "nothing is said to be missing");
  rig.Render();
  report.Check(!rig.Pass->GetExact(), "LAST_ON_TOP is promised without a way to do it");
}
}

int TestLastOnTop(int argc, char* argv[])
{
  vtkObject::GlobalWarningDisplayOff(); // that another method draws, where one cannot
  return RunTest(argc, argv, Setups::All,
    [](Report& report, const Setup& setup)
    {
      report.SetStressTest(37);
      if (setup.HasStorage)
      {
        CheckAll(report, setup);
        if (setup.UseMode == Use::Installed)
        {
          CheckBands(report, setup);
          CheckSamples(report, setup);
        }
        return;
      }
      CheckRefusal(report, setup);
      // Peeling by the blend unit.
      const std::string hidden = vtksys::SystemTools::GetEnv("VTKOIT_HIDE_EXTENSIONS");
      vtksys::SystemTools::PutEnv("VTKOIT_HIDE_EXTENSIONS=GL_EXT_shader_framebuffer_fetch "
                                  "GL_ARB_shader_storage_buffer_object");
      CheckAll(report, setup);
      CheckBands(report, setup);
      vtksys::SystemTools::PutEnv("VTKOIT_HIDE_EXTENSIONS=" + hidden);
    });
}
