// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// What happens when a relation does not hold: the scene is reduced to the props that matter, saved,
// and fails again when it is read back. With comparators that are wrong on purpose.

#include "Oracle/SceneReducer.h"
#include "Oracle/SceneRelations.h"

#include <algorithm>
#include <cstdio>
#include <numeric>

using namespace vtkOITTest;

namespace
{
/// Which of 0...count-1 are left when it fails as long as all of `needed` are there.
std::vector<int> ReduceNumbers(int count, const std::vector<int>& needed, int* evaluations)
{
  std::vector<int> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return Reduce<int>(numbers,
    [&](const std::vector<int>& items)
    {
      ++*evaluations;
      return std::all_of(needed.begin(), needed.end(),
        [&](int number) { return std::find(items.begin(), items.end(), number) != items.end(); });
    });
}

void CheckNumbers(Report& report)
{
  int evaluations = 0;
  for (const std::vector<int>& needed :
    std::vector<std::vector<int>>{ { 3 }, { 0, 19 }, { 7, 8, 9 }, {}, { 0, 5, 10, 15, 19 } })
  {
    report.Check(ReduceNumbers(20, needed, &evaluations) == needed,
      "not reduced to the " + std::to_string(needed.size()) + " that are needed");
  }
  evaluations = 0;
  ReduceNumbers(1000, { 567 }, &evaluations);
  report.Check(evaluations < 60, std::to_string(evaluations) + " evaluations for one of 1000");
  report.Check(ReduceNumbers(20, { 99 }, &evaluations).size() == 20, "reduced what does not fail");
}

/// Whether it fails for an odd number of items only: one is left, whatever it is.
void CheckParity(Report& report)
{
  const std::vector<int> left = Reduce<int>(
    { 1, 2, 3, 4, 5, 6, 7 }, [](const std::vector<int>& items) { return items.size() % 2 == 1; });
  report.Check(left.size() == 1 || left.size() == 7, "parity: " + std::to_string(left.size()));
}

void CheckFiles(Report& report, const std::string& folder)
{
  for (const SceneKind kind : { SceneKind::Aligned, SceneKind::General })
  {
    Scene scene = MakeScene(7, kind);
    scene.Relation = "camera reversal";
    scene.Props.push_back({ "empty", { 0.1f, 0.2f, 0.3f, 0.4f }, {} });
    const std::string file = folder + "/TestSceneReducer.scene";
    Scene read;
    report.Check(SaveScene(scene, file) && LoadScene(read, file), "not saved and read back");
    report.Check(
      read.Seed == scene.Seed && read.Relation == scene.Relation && read.Props == scene.Props,
      "another scene is read back");
    std::remove(file.c_str());
    report.Check(!LoadScene(read, file), "a scene without a file");
  }
  report.Check(!SaveScene(Scene(), folder + "/no/such/folder/x.scene"), "saved into no folder");
  report.Check(MakeScene(7, SceneKind::General).Props == MakeScene(7, SceneKind::General).Props,
    "a seed gives two scenes");
}

/// A comparator that is wrong exactly for scenes with a sphere and a triangle. It draws nothing.
Claim ClaimWrongly(RelationRigs&, const Scene& scene)
{
  bool hasSphere = false;
  bool hasTriangle = false;
  for (const SceneProp& prop : scene.Props)
  {
    hasSphere = hasSphere || prop.Kind == "sphere";
    hasTriangle = hasTriangle || prop.Kind == "triangle";
  }
  const Image black{ 1, 1, { glm::vec4(0.0f) } };
  const Image white{ 1, 1, { glm::vec4(1.0f) } };
  return { hasSphere && hasTriangle ? white : black, black, {} };
}

void CheckBrokenComparator(Report& report, const std::string& folder)
{
  Scene scene;
  for (unsigned int seed = 1; scene.Props.size() < 12; ++seed)
  {
    scene = MakeScene(seed, SceneKind::General);
  }
  Setup setup;
  setup.Method = "abuffer";
  RelationRigs rigs(setup);
  const Relation broken{ "wrong on purpose", 0, {}, ClaimWrongly };
  const std::string file =
    folder + "/abuffer-wrong-on-purpose-" + std::to_string(scene.Seed) + ".scene";
  std::remove(file.c_str());
  std::printf("The failures that follow are wanted:\n");
  Report inner;
  inner.SetContext("broken comparator");
  CheckRelation(inner, rigs, broken, scene, folder);
  report.Check(inner.GetExitStatus() != 0, "the broken comparator passes");

  Scene read;
  report.Check(LoadScene(read, file), "the reduced scene was not saved");
  report.Check(read.Seed == scene.Seed && read.Relation == broken.Name, "other seed or relation");
  report.Check(read.Props.size() == 2, std::to_string(read.Props.size()) + " props are left");
  report.Check(!ClaimWrongly(rigs, read).Holds(), "the reduced scene does not fail");
  std::remove(file.c_str());
}
}

int TestSceneReducer(int argc, char* argv[])
{
  const std::string folder = argc > 1 && argv[1][0] != '\0' && argv[1][0] != '-' ? argv[1] : ".";
  Report report;
  report.SetContext("scene reducer");
  CheckNumbers(report);
  CheckParity(report);
  CheckFiles(report, folder);
  CheckBrokenComparator(report, folder);
  return report.GetExitStatus();
}
