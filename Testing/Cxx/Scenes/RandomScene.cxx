// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes/RandomScene.h"

#include "Scenes/Meshes.h"
#include "Scenes/Random.h"

#include "vtkPolyData.h"

#include <cmath>
#include <fstream>
#include <iomanip>
#include <map>
#include <sstream>

namespace vtkOITTest
{
namespace
{
/// As Rig::ToWorld(), for a viewport of the scene's size.
glm::dvec3 ToWorld(double x, double y, double depth)
{
  return { (2.0 * x - SceneWidth) / SceneHeight, (2.0 * y - SceneHeight) / SceneHeight,
    DepthToZ(depth) };
}

/// How many numbers a kind of prop has.
const std::map<std::string, std::size_t>& GetKinds()
{
  static const std::map<std::string, std::size_t> kinds{ { "quad", 5 }, { "triangle", 9 },
    { "sphere", 4 }, { "empty", 0 } };
  return kinds;
}

SceneProp MakeQuad(Random& random, const Layer& layer)
{
  const double x = random.Below(SceneWidth - 4);
  const double y = random.Below(SceneHeight - 4);
  const double width = 4 + random.Below(SceneWidth - 4);
  const double height = 4 + random.Below(SceneHeight - 4);
  return { "quad", layer.Color,
    { x, y, std::min<double>(x + width, SceneWidth), std::min<double>(y + height, SceneHeight),
      layer.Depth } };
}

SceneProp MakeTriangle(Random& random, const Layer& layer)
{
  SceneProp prop{ "triangle", layer.Color, {} };
  for (int corner = 0; corner < 3; ++corner)
  {
    prop.Numbers.push_back(SceneWidth * random.Uniform());
    prop.Numbers.push_back(SceneHeight * random.Uniform());
    prop.Numbers.push_back(0.1 + 0.8 * random.Uniform());
  }
  return prop;
}

SceneProp MakeBall(Random& random, const Layer& layer)
{
  const double radius = 3.0 + 8.0 * random.Uniform(); // at most 0.34 in depth
  const double x = SceneWidth * random.Uniform();
  const double y = SceneHeight * random.Uniform();
  return { "sphere", layer.Color, { x, y, 0.36 + 0.28 * layer.Depth, radius } };
}

std::vector<glm::dvec3> GetCorners(const SceneProp& prop)
{
  const std::vector<double>& n = prop.Numbers;
  if (prop.Kind == "quad")
  {
    return { ToWorld(n[0], n[1], n[4]), ToWorld(n[2], n[1], n[4]), ToWorld(n[2], n[3], n[4]),
      ToWorld(n[0], n[3], n[4]) };
  }
  return { ToWorld(n[0], n[1], n[2]), ToWorld(n[3], n[4], n[5]), ToWorld(n[6], n[7], n[8]) };
}
}

//------------------------------------------------------------------------------
Scene MakeScene(unsigned int seed, SceneKind kind)
{
  Random random(seed);
  Scene scene;
  scene.Seed = seed;
  std::vector<Layer> layers = random.Layers(4 + random.Below(14));
  for (Layer& layer : layers)
  {
    const double choice = random.Uniform();
    if (choice < 0.08)
    {
      layer.Color.a = 1.0f; // opaque
    }
    if (kind == SceneKind::Aligned)
    {
      // Among equal depths opaque ones would hide the others or not, by the depth test.
      if (choice > 0.7 && layer.Color.a < 1.0f && layers.front().Color.a < 1.0f)
      {
        layer.Depth = layers.front().Depth;
      }
      scene.Props.push_back(MakeQuad(random, layer));
    }
    else
    {
      scene.Props.push_back(choice < 0.3 ? MakeQuad(random, layer)
          : choice < 0.7                 ? MakeTriangle(random, layer)
                                         : MakeBall(random, layer));
    }
  }
  return scene;
}

//------------------------------------------------------------------------------
bool SaveScene(const Scene& scene, const std::string& fileName)
{
  std::ofstream file(fileName);
  file << "seed " << scene.Seed << "\nrelation " << scene.Relation << "\n" << std::setprecision(17);
  for (const SceneProp& prop : scene.Props)
  {
    file << prop.Kind << " " << prop.Color.r << " " << prop.Color.g << " " << prop.Color.b << " "
         << prop.Color.a;
    for (const double number : prop.Numbers)
    {
      file << " " << number;
    }
    file << "\n";
  }
  file.close();
  return file.good();
}

//------------------------------------------------------------------------------
bool LoadScene(Scene& scene, const std::string& fileName)
{
  scene = Scene();
  std::ifstream file(fileName);
  if (!file)
  {
    return false;
  }
  std::string line;
  while (std::getline(file, line))
  {
    std::istringstream text(line);
    std::string word;
    text >> word;
    const auto kind = GetKinds().find(word);
    if (word == "seed")
    {
      text >> scene.Seed;
    }
    else if (word == "relation")
    {
      std::getline(text >> std::ws, scene.Relation);
    }
    else if (kind != GetKinds().end())
    {
      SceneProp prop{ word, {}, std::vector<double>(kind->second) };
      text >> prop.Color.r >> prop.Color.g >> prop.Color.b >> prop.Color.a;
      for (double& number : prop.Numbers)
      {
        text >> number;
      }
      scene.Props.push_back(prop);
    }
    else
    {
      return false;
    }
    if (text.fail())
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void AddProp(Rig& rig, const SceneProp& prop)
{
  Mesh mesh;
  if (prop.Kind == "sphere")
  {
    const std::vector<double>& n = prop.Numbers;
    mesh = MakeSphere(ToWorld(n[0], n[1], n[2]), 2.0 * n[3] / SceneHeight, 6, prop.Color);
  }
  else if (prop.Kind != "empty")
  {
    for (const glm::dvec3& corner : GetCorners(prop))
    {
      mesh.Points.emplace_back(corner);
    }
    mesh.Triangles = { { 0, 1, 2 } };
    if (prop.Kind == "quad")
    {
      mesh.Triangles.push_back({ 0, 2, 3 });
    }
  }
  rig.AddPolyData(MakePolyData(mesh), prop.Color);
}

//------------------------------------------------------------------------------
Image RenderProps(Rig& rig, const std::vector<SceneProp>& props)
{
  rig.RemoveProps();
  for (const SceneProp& prop : props)
  {
    AddProp(rig, prop);
  }
  return rig.Render();
}
}
