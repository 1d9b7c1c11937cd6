// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Relations between pictures that hold for every scene (metamorphic relations): what may be done to
 * a scene, and what that does to its picture.
 */

#ifndef SceneRelations_h
#define SceneRelations_h

#include "Scenes/RandomScene.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace vtkOITTest
{
/// Two pictures that a relation says are equal: to the bit without a tolerance.
struct Claim
{
  Image Is;
  Image Expected;
  Tolerance Allowed;

  bool Holds() const;
};

/// The rigs that relations draw with: made when first needed, then kept.
class RelationRigs
{
public:
  explicit RelationRigs(const Setup& setup);

  const Setup& GetSetup() const { return this->TheSetup; }
  Rig& GetPlain() { return this->Get(this->Plain, this->TheSetup, 1, 1); }
  /// Of twice the size, with the viewport in the middle.
  Rig& GetShifted();
  /// Of half the size, for tiles.
  Rig& GetTile() { return this->Get(this->Tile, this->TheSetup, 1, 2); }
  /// Of another exact method.
  Rig& GetOther();

private:
  Rig& Get(std::unique_ptr<Rig>& rig, const Setup& setup, int times, int dividedBy);

  Setup TheSetup;
  std::unique_ptr<Rig> Plain;
  std::unique_ptr<Rig> Shifted;
  std::unique_ptr<Rig> Tile;
  std::unique_ptr<Rig> Other;
};

struct Relation
{
  std::string Name;
  int StressTest = 0;
  std::vector<SceneKind> Kinds; // of scenes that it holds for
  std::function<Claim(RelationRigs&, const Scene&)> Make;
};

const std::vector<Relation>& GetRelations();

/// Checks the relation for a scene. When it does not hold: prints the seed, reduces the scene and
/// saves it in the folder.
void CheckRelation(Report& report, RelationRigs& rigs, const Relation& relation, const Scene& scene,
  const std::string& folder);
}

#endif
