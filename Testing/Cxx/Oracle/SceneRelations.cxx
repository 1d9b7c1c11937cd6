// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Oracle/SceneRelations.h"

#include "Oracle/ReferenceCompositor.h"
#include "Oracle/SceneReducer.h"
#include "Scenes/Random.h"

#include "vtkCamera.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace vtkOITTest
{
namespace
{
using Props = std::vector<SceneProp>;

bool IsTranslucent(const SceneProp& prop)
{
  return prop.Color.a < 1.0f;
}

/// Rounding of the pictures of two scenes with up to so many fragments in a pixel.
Tolerance RoundingOfTwo(const Setup& setup, std::size_t fragments)
{
  const Tolerance one = ReferenceCompositor::RoundingBoundOfAnyStack(
    static_cast<int>(fragments), setup.FragmentStorage);
  return one + one;
}

/// Whether two quads of it have one depth.
bool HasCoincidentQuads(const Scene& scene)
{
  std::vector<double> depths;
  for (const SceneProp& prop : scene.Props)
  {
    if (prop.Kind == "quad")
    {
      depths.push_back(prop.Numbers[4]);
    }
  }
  std::sort(depths.begin(), depths.end());
  return std::adjacent_find(depths.begin(), depths.end()) != depths.end();
}

/// For pictures that have the same bits, with exceptions. Methods that peel add up coincident
/// fragments in an order that depends on the draws, which rounds the sums of three and more in one
/// way or another (docs/vtkOITDepthPeelingPass.md). `auto` may draw the two by different methods.
Tolerance RoundingOfBits(const Setup& setup, const Scene& scene)
{
  if (setup.Method == "auto")
  {
    return RoundingOfTwo(setup, 2 * scene.Props.size());
  }
  if (setup.Method == "dual")
  {
    // How many layers it peels at once depends on the frame before, and thereby which ones are
    // blended first. Half floats round the mean colour of coincident fragments with each one.
    const bool roundsMeans = setup.FragmentStorage == Storage::Half && HasCoincidentQuads(scene);
    const double rounding = std::ldexp(1.0, -22);
    return roundsMeans ? RoundingOfTwo(setup, 2 * scene.Props.size())
                       : Tolerance{ rounding, rounding };
  }
  const bool hasSums = setup.Method != "abuffer" && HasCoincidentQuads(scene);
  const double rounding = hasSums ? std::ldexp(1.0, -22) : 0.0;
  return { rounding, rounding };
}

Claim PermuteDrawOrder(RelationRigs& rigs, const Scene& scene)
{
  Props shuffled = scene.Props;
  Random(scene.Seed + 1).Shuffle(shuffled);
  return { RenderProps(rigs.GetPlain(), shuffled), RenderProps(rigs.GetPlain(), scene.Props),
    RoundingOfBits(rigs.GetSetup(), scene) };
}

/// Each translucent prop as two of opacity 1 - sqrt(1 - a).
Claim SplitLayers(RelationRigs& rigs, const Scene& scene)
{
  Props split;
  for (SceneProp prop : scene.Props)
  {
    if (IsTranslucent(prop))
    {
      prop.Color.a = static_cast<float>(1.0 - std::sqrt(1.0 - double(prop.Color.a)));
      split.push_back(prop);
    }
    split.push_back(prop);
  }
  return { RenderProps(rigs.GetPlain(), split), RenderProps(rigs.GetPlain(), scene.Props),
    RoundingOfTwo(rigs.GetSetup(), 4 * scene.Props.size()) };
}

/// Every prop twice is every prop once with the opacity 1 - (1 - a)^2.
Claim DuplicateActors(RelationRigs& rigs, const Scene& scene)
{
  Props twice = scene.Props;
  twice.insert(twice.end(), scene.Props.begin(), scene.Props.end());
  Props merged = scene.Props;
  for (SceneProp& prop : merged)
  {
    prop.Color.a =
      IsTranslucent(prop) ? 1.0f - (1.0f - prop.Color.a) * (1.0f - prop.Color.a) : 1.0f;
  }
  return { RenderProps(rigs.GetPlain(), twice), RenderProps(rigs.GetPlain(), merged),
    RoundingOfTwo(rigs.GetSetup(), 4 * scene.Props.size()) };
}

/// Empty props, and props of opacity 0 in front, behind, and in the place of the others.
Claim AddInvisible(RelationRigs& rigs, const Scene& scene)
{
  const glm::vec4 color(1.0f, 1.0f, 0.0f, 0.0f);
  Props more{ { "empty", { 1.0f, 1.0f, 1.0f, 0.5f }, {} } };
  for (const double depth : { 0.03125, 0.5, 0.96875 })
  {
    more.push_back({ "quad", color, { 0.0, 0.0, SceneWidth, SceneHeight, depth } });
  }
  for (SceneProp prop : scene.Props)
  {
    more.push_back(prop);
    prop.Color = color;
    more.push_back(prop);
  }
  return { RenderProps(rigs.GetPlain(), more), RenderProps(rigs.GetPlain(), scene.Props),
    RoundingOfBits(rigs.GetSetup(), scene) };
}

Claim SwapMethods(RelationRigs& rigs, const Scene& scene)
{
  const Image other = RenderProps(rigs.GetOther(), scene.Props);
  return { RenderProps(rigs.GetPlain(), scene.Props), other,
    RoundingOfTwo(rigs.GetSetup(), 2 * scene.Props.size()) };
}

Claim ShiftViewport(RelationRigs& rigs, const Scene& scene)
{
  const Image shifted = RenderProps(rigs.GetShifted(), scene.Props);
  return { Crop(shifted, SceneWidth / 2, SceneHeight / 2, SceneWidth, SceneHeight),
    RenderProps(rigs.GetPlain(), scene.Props), RoundingOfBits(rigs.GetSetup(), scene) };
}

/// Four tiles, as vtkWindowToImageFilter makes them.
Claim RenderTiles(RelationRigs& rigs, const Scene& scene)
{
  const Image expected = RenderProps(rigs.GetPlain(), scene.Props);
  Image image = expected;
  Rig& rig = rigs.GetTile();
  rig.Window->SetTileScale(2);
  vtkCamera* camera = rig.Renderer->GetActiveCamera();
  camera->SetParallelScale(0.5);
  for (int tile = 0; tile < 4; ++tile)
  {
    const int x = tile % 2;
    const int y = tile / 2;
    rig.Window->SetTileViewport(0.5 * x, 0.5 * y, 0.5 * x + 0.5, 0.5 * y + 0.5);
    camera->SetWindowCenter(2.0 * x - 1.0, 2.0 * y - 1.0);
    const Image part = RenderProps(rig, scene.Props);
    for (int row = 0; row < part.Height; ++row)
    {
      std::copy_n(part.Pixels.begin() + std::size_t(row) * part.Width, part.Width,
        image.Pixels.begin() + std::size_t(row + y * part.Height) * image.Width + x * part.Width);
    }
  }
  return { image, expected, RoundingOfBits(rigs.GetSetup(), scene) };
}

/// From behind: the picture of the mirrored scene, whose layers are in the reverse order.
Claim ReverseCamera(RelationRigs& rigs, const Scene& scene)
{
  Props mirrored = scene.Props;
  for (SceneProp& prop : mirrored)
  {
    std::vector<double>& n = prop.Numbers;
    n = { SceneWidth - n[2], n[1], SceneWidth - n[0], n[3], 1.0 - n[4] };
  }
  const Image expected = RenderProps(rigs.GetPlain(), mirrored);
  vtkCamera* camera = rigs.GetPlain().Renderer->GetActiveCamera();
  camera->SetPosition(0.0, 0.0, -2.0);
  const Image image = RenderProps(rigs.GetPlain(), scene.Props);
  camera->SetPosition(0.0, 0.0, 2.0);
  return { image, expected, RoundingOfBits(rigs.GetSetup(), scene) };
}
}

//------------------------------------------------------------------------------
bool Claim::Holds() const
{
  if (this->Is.Pixels.empty() || this->Is.Pixels.size() != this->Expected.Pixels.size())
  {
    return false;
  }
  for (std::size_t i = 0; i < this->Is.Pixels.size(); ++i)
  {
    for (int channel = 0; channel < 4; ++channel)
    {
      const double error =
        std::abs(double(this->Is.Pixels[i][channel]) - double(this->Expected.Pixels[i][channel]));
      if (!(error <= (channel < 3 ? this->Allowed.Color : this->Allowed.Alpha)))
      {
        return false;
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
RelationRigs::RelationRigs(const Setup& setup)
  : TheSetup(setup)
{
}

//------------------------------------------------------------------------------
Rig& RelationRigs::Get(std::unique_ptr<Rig>& rig, const Setup& setup, int times, int dividedBy)
{
  if (!rig)
  {
    rig =
      std::make_unique<Rig>(setup, SceneWidth * times / dividedBy, SceneHeight * times / dividedBy);
  }
  return *rig;
}

//------------------------------------------------------------------------------
Rig& RelationRigs::GetShifted()
{
  Rig& rig = this->Get(this->Shifted, this->TheSetup, 2, 1);
  rig.Renderer->SetViewport(0.25, 0.25, 0.75, 0.75);
  return rig;
}

//------------------------------------------------------------------------------
Rig& RelationRigs::GetOther()
{
  Setup other = this->TheSetup;
  other.IsContender = false;
  other.Method = other.Method == "dual" || !other.HasStorage ? "peel" : "dual";
  other.FragmentStorage = Storage::Float32;
  return this->Get(this->Other, other, 1, 1);
}

//------------------------------------------------------------------------------
const std::vector<Relation>& GetRelations()
{
  const std::vector<SceneKind> any{ SceneKind::Aligned, SceneKind::General };
  static const std::vector<Relation> relations{
    { "draw order", 3, any, PermuteDrawOrder },
    // With coincident props of different colours the weights of the colours would change.
    { "split layers", 31, { SceneKind::General }, SplitLayers },
    { "duplicate actors", 7, { SceneKind::General }, DuplicateActors },
    { "invisible props", 12, any, AddInvisible },
    { "other method", 34, any, SwapMethods },
    // Elsewhere than on borders of pixels moving a viewport may move edges by 1/256 of a pixel.
    { "shifted viewport", 28, { SceneKind::Aligned }, ShiftViewport },
    { "tiles", 27, { SceneKind::Aligned }, RenderTiles },
    { "camera reversal", 23, { SceneKind::Aligned }, ReverseCamera },
  };
  return relations;
}

//------------------------------------------------------------------------------
void CheckRelation(Report& report, RelationRigs& rigs, const Relation& relation, const Scene& scene,
  const std::string& folder)
{
  report.SetStressTest(relation.StressTest);
  const std::string what = relation.Name + ", seed " + std::to_string(scene.Seed);
  const Claim claim = relation.Make(rigs, scene);
  if (rigs.GetSetup().IsContender)
  {
    report.Compare(what, claim.Is, claim.Expected, claim.Allowed);
    return;
  }
  if (report.Check(claim.Holds(), what + ": does not hold"))
  {
    return;
  }
  report.Compare(what, claim.Is, claim.Expected, claim.Allowed); // says how far off
  Scene small = scene;
  small.Relation = relation.Name;
  small.Props = Reduce<SceneProp>(scene.Props,
    [&](const Props& props)
    {
      Scene part = scene;
      part.Props = props;
      return !relation.Make(rigs, part).Holds();
    });
  std::string name =
    rigs.GetSetup().Method + "-" + relation.Name + "-" + std::to_string(scene.Seed) + ".scene";
  std::replace(name.begin(), name.end(), ' ', '-');
  const std::string file = folder + "/" + name;
  report.Check(SaveScene(small, file), "cannot write " + file);
  std::printf("       reduced from %zu props to %zu; run again with --replay %s\n",
    scene.Props.size(), small.Props.size(), file.c_str());
}
}
