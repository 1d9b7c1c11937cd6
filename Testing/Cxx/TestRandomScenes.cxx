// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Relations that hold for every scene (SceneRelations.h), tried with random ones. For hours of it,
// and to see a failure again:
//
//     vtkOITCxxTests TestRandomScenes METHOD --seed 1000 --scenes 5000 --folder /tmp
//     vtkOITCxxTests TestRandomScenes METHOD --replay FILE

#include "Oracle/SceneRelations.h"

#include <cstdio>
#include <cstdlib>

using namespace vtkOITTest;

namespace
{
struct Options
{
  unsigned int Seed = 1;
  int Scenes = 2; // for each setup, which all have their own
  std::string Folder = ".";
  std::string Replay;
};

/// Options with a value, anywhere after the method.
Options ReadOptions(int argc, char* argv[])
{
  Options options;
  for (int i = 2; i + 1 < argc; ++i)
  {
    const std::string name = argv[i];
    const std::string value = argv[i + 1];
    if (name == "--seed")
    {
      options.Seed = static_cast<unsigned int>(std::strtoul(value.c_str(), nullptr, 10));
    }
    else if (name == "--scenes")
    {
      options.Scenes = std::atoi(value.c_str());
    }
    else if (name == "--folder")
    {
      options.Folder = value;
    }
    else if (name == "--replay")
    {
      options.Replay = value;
    }
  }
  return options;
}
}

int TestRandomScenes(int argc, char* argv[])
{
  const Options options = ReadOptions(argc, argv);
  Scene replayed;
  if (!options.Replay.empty() && !LoadScene(replayed, options.Replay))
  {
    std::printf("FAILED: %s is not a scene that can be read\n", options.Replay.c_str());
    return EXIT_FAILURE;
  }
  unsigned int seed = options.Seed;
  return RunTest(argc, argv, Setups::All,
    [&](Report& report, const Setup& setup)
    {
      RelationRigs rigs(setup);
      for (const Relation& relation : GetRelations())
      {
        if (!options.Replay.empty())
        {
          if (relation.Name == replayed.Relation)
          {
            CheckRelation(report, rigs, relation, replayed, options.Folder);
          }
          continue;
        }
        for (int i = 0; i < options.Scenes; ++i)
        {
          for (const SceneKind kind : relation.Kinds)
          {
            CheckRelation(report, rigs, relation, MakeScene(seed + i, kind), options.Folder);
          }
        }
      }
      seed += options.Scenes;
    });
}
