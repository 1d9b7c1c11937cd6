// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// A pass leaves OpenGL's state as it found it, also where it is unusual, and VTK's cache of it
// true. Without translucent props it touches nothing at all.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/GLObjects.h"
#include "Rig/GLStateSnapshot.h"
#include "Rig/Rig.h"
#include "Scenes/Random.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderPass.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderer.h"

#include <functional>

using namespace vtkOITTest;

namespace
{
constexpr int Width = 24;
constexpr int Height = 16;

/// Looks at the state before and after another pass.
class StateProbe : public vtkRenderPass
{
public:
  static StateProbe* New();
  vtkTypeMacro(StateProbe, vtkRenderPass);

  void Render(const vtkRenderState* state) override
  {
    auto* window = static_cast<vtkOpenGLRenderWindow*>(state->GetRenderer()->GetRenderWindow());
    vtkOpenGLState* glState = window->GetState();
    glState->Push();
    if (this->Prepare)
    {
      this->Prepare(glState);
    }
    const GLStateSnapshot before = GLStateSnapshot::Take(this->Extent);
    this->Delegate->Render(state);
    const GLStateSnapshot after = GLStateSnapshot::Take(this->Extent);
    this->Changes = before.FindChanges(after);
    this->Stale = GLStateSnapshot::FindStaleCache(glState);
    ++this->NumberOfRenders;
    if (this->Undo)
    {
      this->Undo(glState);
    }
    glState->Pop();
  }

  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Delegate->ReleaseGraphicsResources(window);
  }

  vtkSmartPointer<vtkRenderPass> Delegate;
  std::function<void(vtkOpenGLState*)> Prepare;
  std::function<void(vtkOpenGLState*)> Undo;
  GLStateSnapshot::Extent Extent = GLStateSnapshot::WithoutDrawing;
  std::vector<std::string> Changes;
  std::vector<std::string> Stale;
  int NumberOfRenders = 0;

protected:
  StateProbe() = default;
  ~StateProbe() override = default;
};
vtkStandardNewMacro(StateProbe);

/// Everything that a pass might use is in use by somebody else, in an odd way.
class OddState
{
public:
  void Set(vtkOpenGLState* state)
  {
    glGenBuffers(1, &this->Buffer);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Buffer);
    glBufferData(GL_SHADER_STORAGE_BUFFER, 65536, nullptr, GL_STATIC_DRAW);
    for (GLuint i = 0; i < 8; ++i)
    {
      glBindBufferRange(GL_SHADER_STORAGE_BUFFER, i, this->Buffer, 1024 * i, 512);
    }
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, this->Buffer);
    glBindBufferRange(GL_ATOMIC_COUNTER_BUFFER, 0, this->Buffer, 256, 128);
    glBindBuffer(GL_COPY_READ_BUFFER, this->Buffer);
    glBindBuffer(GL_COPY_WRITE_BUFFER, this->Buffer);

    state->vtkglActiveTexture(GL_TEXTURE0 + 5);
    glGenTextures(1, &this->Texture);
    glBindTexture(GL_TEXTURE_2D, this->Texture);
    glTexStorage2D(GL_TEXTURE_2D, 2, GL_RGBA8, 8, 8);
    glBindTexture(GL_TEXTURE_2D, 0);
    for (GLuint i = 0; i < 8; ++i)
    {
      glBindImageTexture(i, this->Texture, 1, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA8);
    }

    state->vtkglDisable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ZERO, GL_DST_ALPHA, GL_ONE);
    state->vtkglBlendEquationSeparate(GL_FUNC_REVERSE_SUBTRACT, GL_MAX);
    state->vtkglDepthMask(GL_FALSE);
    state->vtkglEnable(GL_CULL_FACE);
    state->vtkglCullFace(GL_FRONT);
    state->vtkglEnable(GL_SCISSOR_TEST);
    state->vtkglScissor(0, 0, Width / 2, Height);
    state->vtkglClearColor(0.5f, 0.25f, 0.125f, 0.75f);
    state->vtkglClearDepth(0.5);
  }

  void Undo(vtkOpenGLState*)
  {
    for (GLuint i = 0; i < 8; ++i)
    {
      glBindBufferBase(GL_SHADER_STORAGE_BUFFER, i, 0);
      glBindImageTexture(i, 0, 0, GL_FALSE, 0, GL_READ_ONLY, GL_R8);
    }
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, 0);
    glBindBufferBase(GL_ATOMIC_COUNTER_BUFFER, 0, 0);
    glBindBuffer(GL_COPY_READ_BUFFER, 0);
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
    glDeleteBuffers(1, &this->Buffer);
    glDeleteTextures(1, &this->Texture);
  }

private:
  GLuint Buffer = 0;
  GLuint Texture = 0;
};

/// States that nobody expects: neither VTK nor the pass sets them, but they change what is drawn or
/// read. GL_LESS only keeps what is at the depth of opaque geometry, which there is none of.
class HostileState
{
public:
  void Set(vtkOpenGLState*)
  {
    for (const GLenum capability : Capabilities)
    {
      glEnable(capability);
    }
    glLogicOp(GL_XOR);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glPolygonOffset(-3.0f, -5000.0f);
    glFrontFace(GL_CW);
    glSampleCoverage(0.0f, GL_FALSE);
    glSampleMaski(0, 0);
    glDepthFunc(GL_LESS);
    glColorMaski(1, GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
    glDisablei(GL_BLEND, 2);
    glClampColor(GL_CLAMP_READ_COLOR, GL_TRUE);
    for (const GLenum name : { GL_PACK_ROW_LENGTH, GL_UNPACK_ROW_LENGTH, GL_UNPACK_IMAGE_HEIGHT })
    {
      glPixelStorei(name, 1000);
    }
    for (const GLenum name :
      { GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_ROWS })
    {
      glPixelStorei(name, 7);
    }
    glPixelStorei(GL_PACK_ALIGNMENT, 8);
    glGenBuffers(1, &this->Buffer);
    for (const GLenum target : { GL_PIXEL_PACK_BUFFER, GL_PIXEL_UNPACK_BUFFER })
    {
      glBindBuffer(target, this->Buffer);
      glBufferData(target, 16, nullptr, GL_STREAM_DRAW);
    }
    glGenTextures(4, this->Textures);
    glGenSamplers(1, &this->Sampler);
    glSamplerParameteri(this->Sampler, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    GLint active = 0;
    glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
    for (int i = 0; i < 4; ++i)
    {
      glActiveTexture(GL_TEXTURE0 + 12 + i);
      glBindTexture(i % 2 ? GL_TEXTURE_2D : GL_TEXTURE_2D_ARRAY, this->Textures[i]);
      glBindSampler(12 + i, this->Sampler);
    }
    glActiveTexture(active);
  }

  void Undo(vtkOpenGLState*)
  {
    for (const GLenum capability : Capabilities)
    {
      glDisable(capability);
    }
    glLogicOp(GL_COPY);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glPolygonOffset(0.0f, 0.0f);
    glFrontFace(GL_CCW);
    glSampleCoverage(1.0f, GL_FALSE);
    glSampleMaski(0, ~0u);
    glDepthFunc(GL_LEQUAL);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glEnablei(GL_BLEND, 2);
    glClampColor(GL_CLAMP_READ_COLOR, GL_FIXED_ONLY);
    for (const GLenum name : { GL_PACK_ROW_LENGTH, GL_UNPACK_ROW_LENGTH, GL_UNPACK_IMAGE_HEIGHT,
           GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_ROWS })
    {
      glPixelStorei(name, 0);
    }
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    for (GLuint unit = 12; unit < 16; ++unit)
    {
      glBindSampler(unit, 0);
    }
    glDeleteBuffers(1, &this->Buffer);
    glDeleteTextures(4, this->Textures);
    glDeleteSamplers(1, &this->Sampler);
  }

private:
  static constexpr GLenum Capabilities[] = { GL_COLOR_LOGIC_OP, GL_POLYGON_OFFSET_FILL,
    GL_PRIMITIVE_RESTART, GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_COVERAGE, GL_SAMPLE_MASK,
    GL_CLIP_DISTANCE0, GL_CLIP_DISTANCE0 + 3, GL_RASTERIZER_DISCARD };
  GLuint Buffer = 0;
  GLuint Textures[4] = { 0, 0, 0, 0 };
  GLuint Sampler = 0;
};

void CheckProbe(Report& report, StateProbe* probe, const std::string& what)
{
  report.Check(probe->NumberOfRenders > 0, what + ": the pass was not rendered");
  for (const std::string& change : probe->Changes)
  {
    report.Check(false, std::string(what).append(": changed ").append(change));
  }
  for (const std::string& stale : probe->Stale)
  {
    report.Check(false, std::string(what).append(": VTK's cache is stale: ").append(stale));
  }
  probe->NumberOfRenders = 0;
}
}

int TestGLState(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      Rig rig(setup, Width, Height);
      setup.Detach(rig.Renderer);
      vtkNew<StateProbe> probe;
      probe->Delegate = rig.Pass;
      vtkNew<vtkRenderStepsPass> steps;
      steps->SetTranslucentPass(probe);
      rig.Renderer->SetPass(steps);

      rig.AddQuad({ 0.9f, { 0.1f, 0.2f, 0.3f, 1.0f } });
      probe->Extent = GLStateSnapshot::WithDrawing;
      rig.Render();
      CheckProbe(report, probe, "nothing translucent");
      probe->Extent = GLStateSnapshot::WithoutDrawing;
      rig.RemoveProps();

      // 40 layers: beyond what is sorted in registers, and one group of equal depths.
      std::vector<Layer> layers = Random(2).Layers(40);
      layers[7].Depth = layers[30].Depth;
      rig.AddStack(layers);
      const glm::dvec4 background = rig.GetBackground();
      const glm::dvec4 composite = ReferenceCompositor::Composite(layers, background);
      const Tolerance bound =
        ReferenceCompositor::RoundingBound(layers, background, setup.FragmentStorage);
      for (int frame = 0; frame < 3; ++frame)
      {
        const std::string what = "frame " + std::to_string(frame);
        report.Compare(what, rig.Render(), Everywhere(composite), bound);
        CheckProbe(report, probe, what);
        rig.RenderWindow();
        CheckProbe(report, probe, what + " in the window");
      }
      rig.Pass->SetMaximumBufferSize(1 << 20);
      rig.Render();
      CheckProbe(report, probe, "with a small store");

      OddState odd;
      probe->Prepare = [&odd](vtkOpenGLState* state) { odd.Set(state); };
      probe->Undo = [&odd](vtkOpenGLState* state) { odd.Undo(state); };
      report.Compare(
        "in an odd state, scissored to the left half", rig.Render(),
        [&](int x, int) { return x < Width / 2 ? composite : background; }, bound);
      CheckProbe(report, probe, "odd state");

      rig.Pass->SetMaximumBufferSize(0);
      HostileState hostile;
      probe->Prepare = [&hostile](vtkOpenGLState* state) { hostile.Set(state); };
      probe->Undo = [&hostile](vtkOpenGLState* state) { hostile.Undo(state); };
      for (int frame = 0; frame < 2; ++frame)
      {
        report.Compare("in a hostile state", rig.Render(), Everywhere(composite), bound);
        report.Check(rig.Pass->GetMaximumDepthComplexity() >= 39 || rig.Pass->IsA("vtkOITAutoPass"),
          "in a hostile state: the depth complexity is " +
            std::to_string(rig.Pass->GetMaximumDepthComplexity()));
        CheckProbe(report, probe, "hostile state");
      }
    });
}
