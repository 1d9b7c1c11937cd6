// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A scene with a bit of everything that a translucent layer is made from, for changing one thing
 * at a time: lit and unlit, textured, mapped by a table, clipped, overlapping, and an opaque prop
 * among them. In perspective.
 */

#ifndef ReuseScene_h
#define ReuseScene_h

#include "vtkNew.h"

class vtkActor;
class vtkDataSetMapper;
class vtkFloatArray;
class vtkImageData;
class vtkLight;
class vtkLookupTable;
class vtkOITAutoPass;
class vtkPlane;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkSphereSource;
class vtkTexture;

namespace vtkOITTest
{
class Rig;

struct ReuseScene
{
  /// Fills the rig's renderer.
  explicit ReuseScene(Rig& rig);
  ~ReuseScene();

  Rig& TheRig;
  vtkOITAutoPass* Pass = nullptr;

  vtkNew<vtkSphereSource> BallSource;
  vtkNew<vtkPolyDataMapper> BallMapper;
  vtkNew<vtkActor> Ball;       // lit
  vtkNew<vtkActor> SecondBall; // crosses the first one
  vtkNew<vtkActor> OpaqueBall;

  vtkNew<vtkPolyData> Table; // a quad of four cells, coloured by a lookup table
  vtkNew<vtkFloatArray> TableValues;
  vtkNew<vtkLookupTable> Colors;
  vtkNew<vtkDataSetMapper> TableMapper;
  vtkNew<vtkActor> TableActor;

  vtkNew<vtkImageData> TextureImage;
  vtkNew<vtkTexture> Texture;
  vtkNew<vtkActor> Poster; // textured

  vtkNew<vtkPlane> ClippingPlane; // of Poster's mapper
  vtkNew<vtkLight> Lamp;          // of the scene
  vtkNew<vtkLight> CameraLamp;    // a spot that follows the camera
  vtkNew<vtkLight> Headlight;
};
}

#endif
