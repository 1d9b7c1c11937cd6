// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITMeshShapes_h
#define vtkOITMeshShapes_h

#include "Private/Auto/vtkOITMeshShape.h"

#include "vtkType.h"

#include <map>

class vtkActor;
class vtkProp;

/// The shapes of the meshes of props, each proven once. Of a mesh of which nothing was proven, and that
/// has changed since the last frame, nothing is tried to be proven until it stays as it is for a frame: what
/// is animated is seldom convex, and a proof costs as much as drawing the mesh.
class vtkOITMeshShapes
{
public:
  /// As the camera sees the triangles of a prop: ...Inside for a transformation that mirrors.
  /// Unknown for props that draw anything but the surface of their mesh, and for meshes of more
  /// than LargestMesh triangles. `balls` in world coordinates: of closed props that are not
  /// stretched or skewed.
  vtkOITMeshShape Find(vtkProp* prop, vtkOITMeshBalls& balls);

  /// Whether a prop draws nothing but the surface of its mesh, so that its depths are within its bounds.
  static bool IsSurface(vtkProp* prop);

  /// Ends a frame; drops what no prop has asked for in the last LongestRest calls.
  void Prune();

  /// Proofs that were tried so far.
  int GetNumberOfProofs() const { return this->NumberOfProofs; }

  static constexpr vtkIdType LargestMesh = 100000;
  static constexpr int LongestRest = 100;
  /// Polygons of meshes whose proof costs no more than what else a prop does in a frame.
  static constexpr vtkIdType CheapMesh = 100;

private:
  struct Entry
  {
    vtkMTimeType Time = 0;   // when it was as it was seen last
    bool IsTried = false;    // since then
    bool HasChanged = false; // when it was seen last
    vtkOITMeshShape Shape = vtkOITMeshShape::Unknown;
    vtkOITMeshBalls Balls;
    int Rest = 0; // calls of Prune() since it was asked for
  };
  std::map<vtkPolyData*, Entry> Entries;
  // New meshes in so many frames in a row are a time series: they wait until they rest.
  static constexpr int LongestSeries = 3;
  int FramesWithNew = 0;
  bool HasNew = false; // this frame
  int NumberOfProofs = 0;
};

/// The actor, when a prop is one whose surface is drawn by VTK's own mapper for polygons, without
/// changes of its shaders; otherwise nullptr.
vtkActor* vtkOITFindPlainActor(vtkProp* prop);

/// The same for VTK's own mappers for composite data.
vtkActor* vtkOITFindCompositeActor(vtkProp* prop);

#endif
