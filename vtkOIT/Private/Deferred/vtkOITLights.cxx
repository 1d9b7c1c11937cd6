// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Deferred/vtkOITLights.h"

#include "Private/Frame/vtkOITFrame.h"
#include "Private/GL/vtkOITAllocation.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr int FloatsPerLight = 16;
constexpr int HeadlightOnly = 1;    // of vtkOpenGLRenderer::GetLightingComplexity()
constexpr double WidestCone = 90.0; // degrees; from there on a positional light has none

// What a light costs when mappers compute it for each fragment, less what it costs later, in the unit of
// a directional one; and what it takes to make up for larger fragments, some of which are sorted in memory
// until the networks for them are compiled.
// Measured with llvmpipe: docs/vtkOITDeferredPeelingPass.md.
constexpr double PositionalCost = 2.3;
constexpr double Overhead = 4.5;

enum Kind
{
  Directional,
  Positional,
  Spot
};

Kind FindKind(vtkLight* light)
{
  if (!light->GetPositional())
  {
    return Directional;
  }
  return light->GetConeAngle() < WidestCone ? Spot : Positional;
}

using LightTexels = std::array<float, FloatsPerLight>;

/// To view coordinates: of a point, or of a direction.
class ToView
{
public:
  explicit ToView(vtkOpenGLRenderer* renderer)
    : View(renderer->GetActiveCamera()->GetModelViewTransformObject())
    , User(renderer->GetUserLightTransform())
  {
  }
  std::array<double, 3> Point(vtkLight* light, const double in[3]) const
  {
    std::array<double, 3> out{};
    this->View->TransformPoint(in, out.data());
    if (this->IsMoved(light))
    {
      const std::array<double, 3> before = out;
      this->User->TransformPoint(before.data(), out.data());
    }
    return out;
  }
  std::array<double, 3> Direction(vtkLight* light, const double in[3]) const
  {
    std::array<double, 3> out{};
    this->View->TransformNormal(in, out.data());
    if (this->IsMoved(light))
    {
      const std::array<double, 3> before = out;
      this->User->TransformNormal(before.data(), out.data());
    }
    return out;
  }

private:
  bool IsMoved(vtkLight* light) const { return this->User && !light->LightTypeIsSceneLight(); }
  vtkTransform* View;
  vtkTransform* User;
};

LightTexels Describe(vtkLight* light, Kind kind, const ToView& toView)
{
  double from[3];
  double to[3];
  light->GetTransformedPosition(from);
  light->GetTransformedFocalPoint(to);
  double along[3];
  vtkMath::Subtract(to, from, along);
  vtkMath::Normalize(along);
  const std::array<double, 3> direction = toView.Direction(light, along);
  const std::array<double, 3> position = toView.Point(light, from);
  LightTexels texels{};
  for (int i = 0; i < 3; ++i)
  {
    texels[i] = static_cast<float>(kind == Directional ? direction[i] : position[i]);
    texels[4 + i] = static_cast<float>(light->GetDiffuseColor()[i] * light->GetIntensity());
    texels[8 + i] = static_cast<float>(kind == Directional ? position[i] : direction[i]);
  }
  const double* attenuation = light->GetAttenuationValues();
  texels[3] = static_cast<float>(attenuation[0]);
  texels[7] = static_cast<float>(attenuation[1]);
  texels[12] = static_cast<float>(attenuation[2]);
  texels[11] = static_cast<float>(std::cos(vtkMath::RadiansFromDegrees(light->GetConeAngle())));
  texels[13] = static_cast<float>(light->GetExponent());
  return texels;
}
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITLights::Update(const vtkOITFrame& frame)
{
  this->Attach(frame.Window);
  this->Find(frame.Renderer);
  return this->Ends[2] > 0 ? this->Upload() : vtkOITFailure();
}

//------------------------------------------------------------------------------
void vtkOITLights::Find(vtkRenderer* renderer)
{
  auto* lighting = vtkOpenGLRenderer::SafeDownCast(renderer);
  this->Ends = {};
  this->Texels.clear();
  if (!lighting || !vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera()))
  {
    return;
  }
  const int complexity = static_cast<int>(lighting->GetLightingComplexity());
  this->IsHeadlight = complexity == HeadlightOnly;
  const ToView toView(lighting);
  vtkLightCollection* lights = renderer->GetLights();
  for (const Kind kind : { Directional, Positional, Spot })
  {
    vtkCollectionSimpleIterator cookie;
    lights->InitTraversal(cookie);
    while (vtkLight* light = lights->GetNextLight(cookie))
    {
      if (light->GetSwitch() && FindKind(light) == kind)
      {
        const LightTexels texels = Describe(light, kind, toView);
        this->Texels.insert(this->Texels.end(), texels.begin(), texels.end());
      }
    }
    this->Ends[kind] = static_cast<int>(this->Texels.size()) / FloatsPerLight;
  }
  if (this->IsHeadlight && !this->Texels.empty())
  {
    const std::array<float, 3> ahead = { 0.0f, 0.0f, -1.0f };
    std::copy(ahead.begin(), ahead.end(), this->Texels.begin());
  }
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITLights::Upload()
{
  const auto bytes = static_cast<GLsizeiptr>(this->Texels.size() * sizeof(float));
  const vtkOITAllocation allocation;
  GLint buffer = 0;
  GLint texture = 0;
  glGetIntegerv(GL_TEXTURE_BUFFER, &buffer);
  glGetIntegerv(GL_TEXTURE_BINDING_BUFFER, &texture);
  if (this->Buffer == 0)
  {
    glGenBuffers(1, &this->Buffer);
    glGenTextures(1, &this->Texture);
  }
  glBindBuffer(GL_TEXTURE_BUFFER, this->Buffer);
  // A new memory each time, so that nobody waits for the last frame.
  glBufferData(GL_TEXTURE_BUFFER, bytes, this->Texels.data(), GL_STREAM_DRAW);
  glBindTexture(GL_TEXTURE_BUFFER, this->Texture);
  glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, this->Buffer);
  glBindTexture(GL_TEXTURE_BUFFER, texture);
  glBindBuffer(GL_TEXTURE_BUFFER, buffer);
  this->Capacity = bytes;
  return allocation.Check("a buffer of lights");
}

//------------------------------------------------------------------------------
bool vtkOITLights::Pays(bool isDone) const
{
  const int positional = this->Ends[2] - this->Ends[0];
  const double saved = this->Ends[0] + PositionalCost * positional;
  return saved > (isDone ? Overhead / 2.0 : Overhead);
}

//------------------------------------------------------------------------------
void vtkOITLights::Bind(vtkOpenGLState* state, int textureUnit) const
{
  state->vtkglActiveTexture(GL_TEXTURE0 + textureUnit);
  glBindTexture(GL_TEXTURE_BUFFER, this->Texture);
}

//------------------------------------------------------------------------------
void vtkOITLights::Unbind(vtkOpenGLState* state, int textureUnit) const
{
  state->vtkglActiveTexture(GL_TEXTURE0 + textureUnit);
  glBindTexture(GL_TEXTURE_BUFFER, 0);
}

//------------------------------------------------------------------------------
void vtkOITLights::SetUniforms(
  vtkShaderProgram* program, const vtkOITFrame& frame, int textureUnit, int x, int y) const
{
  auto* camera = vtkOpenGLCamera::SafeDownCast(frame.Renderer->GetActiveCamera());
  vtkMatrix4x4* toView = nullptr;
  vtkMatrix3x3* normals = nullptr;
  vtkMatrix4x4* toClip = nullptr;
  vtkMatrix4x4* both = nullptr;
  camera->GetKeyMatrices(frame.Renderer, toView, normals, toClip, both);
  vtkNew<vtkMatrix4x4> fromClip;
  vtkMatrix4x4::Invert(toClip, fromClip); // both are transposed, as GL has them
  const vtkOITRectangle& v = frame.Viewport;
  const float map[4] = { static_cast<float>(v.X - x), static_cast<float>(v.Y - y),
    2.0f / static_cast<float>(v.Width), 2.0f / static_cast<float>(v.Height) };
  program->SetUniformMatrix("oitFromClip", fromClip);
  program->SetUniform4f("oitViewportMap", map);
  const float nothing[FloatsPerLight] = {};
  const float* first = this->Ends[0] > 0 ? this->Texels.data() : nothing;
  program->SetUniform3f("oitFirstAlong", first);
  program->SetUniform3f("oitFirstColor", first + 4);
  program->SetUniform3f("oitFirstPosition", first + 8);
  program->SetUniformi("oitIsHeadlight", this->IsHeadlight ? 1 : 0);
  program->SetUniformi("oitLightTexels", textureUnit);
  // VTK has no vector of three integers.
  program->SetUniform2i("oitLightEnds", this->Ends.data());
  program->SetUniformi("oitLightCount", this->Ends[2]);
}

//------------------------------------------------------------------------------
void vtkOITLights::Delete()
{
  glDeleteTextures(1, &this->Texture);
  glDeleteBuffers(1, &this->Buffer);
}

//------------------------------------------------------------------------------
void vtkOITLights::Forget()
{
  this->Buffer = this->Texture = 0;
  this->Capacity = 0;
}
