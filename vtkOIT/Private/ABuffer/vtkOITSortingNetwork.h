// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITSortingNetwork_h
#define vtkOITSortingNetwork_h

#include <string>

/// GLSL text that loads fragments into registers, sorts them there and does something with them, by
/// macros of the stage: `//VTK::OIT::Registers` of its file.
///@{
/// Of Resolve: up to `size` fragments, which are blended.
std::string vtkOITRegisterResolve(int size);
/// Of SecondChance: up to `size` fragments, which are blended; of more, the `kept` nearest, while
/// those behind are not seen.
std::string vtkOITRegisterSelect(int size, int kept);
/// Of Walk: up to `most` fragments, by walks over the list that blend the `kept` nearest of those that
/// are left, less one: little text, which compiles fast. Takes time in the square of the length.
std::string vtkOITRegisterWalk(int kept, int most);
/// Of Sort: `size` nodes, which are linked.
std::string vtkOITRegisterSort(int size);
/// Of Merge: runs of `size` fragments, and the nearest ones of so many runs.
struct vtkOITRegisterMerge
{
  vtkOITRegisterMerge(int size, int runs);
  std::string Declare;
  std::string Run;
  std::string Load;
  std::string Compare;
};
///@}

#endif
