// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A headless window whose fragments have depths and colours that a test chooses exactly.
 *
 * The camera looks along -z in parallel projection with clipping planes such that the window
 * depth of a point is (1 - z) / 2 without rounding for depths that are multiples of 2^-25;
 * everything is drawn unlit, so a fragment has the colour of its property.
 *
 * Positions are in pixels of the viewport, so that a test knows which pixels a quad covers.
 */

#ifndef Rig_h
#define Rig_h

#include "Rig/Image.h"
#include "Rig/Setup.h"

#include "vtkSmartPointer.h"

#include <glm/vec3.hpp>

#include <vector>

class vtkActor;
class vtkCamera;
class vtkObject;
class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkPolyData;
class vtkRenderWindow;
class vtkRenderer;

namespace vtkOITTest
{
/// A rectangle of the viewport in pixels, from (X0, Y0) up to (X1, Y1).
struct PixelRectangle
{
  double X0 = 0.0;
  double Y0 = 0.0;
  double X1 = 0.0;
  double Y1 = 0.0;

  bool Contains(int x, int y) const
  {
    return x + 0.5 > this->X0 && x + 0.5 < this->X1 && y + 0.5 > this->Y0 && y + 0.5 < this->Y1;
  }
};

/// The world z that has the window depth.
inline double DepthToZ(double depth)
{
  return 1.0 - 2.0 * depth;
}

class Rig
{
public:
  /// A window of this size with one renderer and the setup's pass in it.
  Rig(const Setup& setup, int width, int height);
  ~Rig();
  Rig(const Rig&) = delete;
  void operator=(const Rig&) = delete;

  /// From now on the next rig takes the window of the one before, when that is as a new one, and
  /// with it the compiled shaders; or no longer. Drops the window that is kept.
  static void KeepWindow(bool keep);

  vtkSmartPointer<vtkOITPass> Pass;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;

  vtkOpenGLRenderWindow* GetGLWindow();
  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  void SetSize(int width, int height);

  /// Default: (0.2, 0.4, 0.6, 0.4), which 8 bits hold exactly; with an alpha, so that each
  /// comparison tests alpha too.
  void SetBackground(const glm::dvec4& color);
  glm::dvec4 GetBackground() const;

  /// What Render() draws into: component type VTK_FLOAT (default) or VTK_UNSIGNED_CHAR, and a
  /// depth format of vtkTextureObject (default Float32).
  void SetTargetFormat(int colorType, int depthFormat);

  /// The whole viewport, in pixels.
  PixelRectangle GetFullRectangle() const;
  /// World position of a point of the viewport, z for a window depth.
  glm::dvec3 ToWorld(double x, double y, double depth) const;

  /// An unlit actor of this colour; opaque actors have opacity 1 and are not forced translucent.
  vtkActor* AddPolyData(vtkPolyData* polydata, const glm::vec4& color);
  /// A quad of constant depth over the rectangle.
  vtkActor* AddQuad(const Layer& layer, const PixelRectangle& rectangle);
  vtkActor* AddQuad(const Layer& layer);
  /// A quad over the whole viewport whose depth goes from one value at the left border to one at
  /// the right border.
  vtkActor* AddRamp(double leftDepth, double rightDepth, const glm::vec4& color);
  /// One actor for each layer, over the whole viewport, drawn in the given order.
  void AddStack(const std::vector<Layer>& layers);
  /// One actor with a quad over the whole viewport for each depth, all of one colour.
  vtkActor* AddEqualLayers(const std::vector<float>& depths, const glm::vec4& color);
  void RemoveProps();
  /// The actors of the renderer, and another order of them for drawing. They keep their shaders.
  ///@{
  std::vector<vtkSmartPointer<vtkActor>> GetActors() const;
  void SetDrawOrder(const std::vector<vtkSmartPointer<vtkActor>>& actors);
  ///@}

  /// Renders a frame into a framebuffer of SetTargetFormat() and reads it back. Contenders render
  /// into the window instead, as their users have it: float framebuffers are not theirs.
  Image Render();
  /// The depth of each pixel after Render(), in all channels.
  const Image& GetDepth() const { return this->Depth; }
  /// Renders a frame into the window and reads its 8-bit picture, as numbers in [0,1].
  Image RenderWindow();
  /// Largest error that 8-bit blending adds in RenderWindow(): source, factor and result are each
  /// rounded to 1/255.
  static Tolerance WindowTolerance() { return { 1.5 / 255.0, 1.5 / 255.0 }; }

private:
  vtkActor* AddQuadOf(const std::vector<glm::dvec3>& corners, const glm::vec4& color);
  void BindTarget(vtkObject*, unsigned long, void*);
  void ReadTarget(vtkObject*, unsigned long, void*);
  Image RenderWindowWithDepth();

  Setup TheSetup;
  int Width;
  int Height;
  int TargetColorType;
  int TargetDepthFormat;
  bool UseTarget = false;
  vtkSmartPointer<vtkCamera> Camera;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Target;
  Image Color;
  Image Depth;
};

/// A pixel under uniform layers: for use as Report::Expected.
Report::Expected Everywhere(const glm::dvec4& color);
}

#endif
