// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Rig/GLStateSnapshot.h"

#include "Rig/GLObjects.h"

#include "vtkOpenGLState.h"

#include <sstream>

namespace vtkOITTest
{
namespace
{
struct Name
{
  GLenum Value;
  const char* Text;
};
#define vtkOITName(name)                                                                           \
  {                                                                                                \
    name, #name                                                                                    \
  }

const Name Capabilities[] = { vtkOITName(GL_BLEND), vtkOITName(GL_DEPTH_TEST),
  vtkOITName(GL_SCISSOR_TEST), vtkOITName(GL_CULL_FACE), vtkOITName(GL_STENCIL_TEST),
  vtkOITName(GL_MULTISAMPLE), vtkOITName(GL_DITHER), vtkOITName(GL_COLOR_LOGIC_OP),
  vtkOITName(GL_SAMPLE_ALPHA_TO_COVERAGE), vtkOITName(GL_SAMPLE_ALPHA_TO_ONE),
  vtkOITName(GL_SAMPLE_COVERAGE), vtkOITName(GL_SAMPLE_MASK), vtkOITName(GL_SAMPLE_SHADING),
  vtkOITName(GL_RASTERIZER_DISCARD), vtkOITName(GL_PRIMITIVE_RESTART),
  vtkOITName(GL_POLYGON_OFFSET_FILL), vtkOITName(GL_FRAMEBUFFER_SRGB), vtkOITName(GL_DEPTH_CLAMP),
  vtkOITName(GL_PROGRAM_POINT_SIZE), vtkOITName(GL_TEXTURE_CUBE_MAP_SEAMLESS) };

// Up to four integers each.
const Name Integers[] = { vtkOITName(GL_BLEND_SRC_RGB), vtkOITName(GL_BLEND_DST_RGB),
  vtkOITName(GL_BLEND_SRC_ALPHA), vtkOITName(GL_BLEND_DST_ALPHA), vtkOITName(GL_BLEND_EQUATION_RGB),
  vtkOITName(GL_BLEND_EQUATION_ALPHA), vtkOITName(GL_DEPTH_FUNC), vtkOITName(GL_DEPTH_WRITEMASK),
  vtkOITName(GL_COLOR_WRITEMASK), vtkOITName(GL_VIEWPORT), vtkOITName(GL_SCISSOR_BOX),
  vtkOITName(GL_CULL_FACE_MODE), vtkOITName(GL_FRONT_FACE), vtkOITName(GL_STENCIL_FUNC),
  vtkOITName(GL_STENCIL_REF), vtkOITName(GL_STENCIL_WRITEMASK), vtkOITName(GL_STENCIL_CLEAR_VALUE),
  vtkOITName(GL_READ_BUFFER), vtkOITName(GL_DRAW_FRAMEBUFFER_BINDING),
  vtkOITName(GL_READ_FRAMEBUFFER_BINDING), vtkOITName(GL_RENDERBUFFER_BINDING),
  vtkOITName(GL_ACTIVE_TEXTURE), vtkOITName(GL_SHADER_STORAGE_BUFFER_BINDING),
  vtkOITName(GL_UNIFORM_BUFFER_BINDING), vtkOITName(GL_ATOMIC_COUNTER_BUFFER_BINDING),
  vtkOITName(GL_COPY_READ_BUFFER_BINDING), vtkOITName(GL_COPY_WRITE_BUFFER_BINDING),
  vtkOITName(GL_PIXEL_PACK_BUFFER_BINDING), vtkOITName(GL_PIXEL_UNPACK_BUFFER_BINDING),
  vtkOITName(GL_DRAW_INDIRECT_BUFFER_BINDING), vtkOITName(GL_DISPATCH_INDIRECT_BUFFER_BINDING),
  vtkOITName(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING), vtkOITName(GL_PACK_ALIGNMENT),
  vtkOITName(GL_PACK_ROW_LENGTH), vtkOITName(GL_PACK_SKIP_PIXELS), vtkOITName(GL_PACK_SKIP_ROWS),
  vtkOITName(GL_UNPACK_ALIGNMENT), vtkOITName(GL_UNPACK_ROW_LENGTH),
  vtkOITName(GL_UNPACK_SKIP_PIXELS), vtkOITName(GL_UNPACK_SKIP_ROWS),
  vtkOITName(GL_UNPACK_IMAGE_HEIGHT), vtkOITName(GL_PROVOKING_VERTEX), vtkOITName(GL_LOGIC_OP_MODE),
  vtkOITName(GL_POLYGON_MODE), vtkOITName(GL_CLAMP_READ_COLOR) };

const Name Floats[] = { vtkOITName(GL_COLOR_CLEAR_VALUE), vtkOITName(GL_DEPTH_CLEAR_VALUE),
  vtkOITName(GL_DEPTH_RANGE), vtkOITName(GL_BLEND_COLOR), vtkOITName(GL_LINE_WIDTH),
  vtkOITName(GL_POINT_SIZE), vtkOITName(GL_POLYGON_OFFSET_FACTOR),
  vtkOITName(GL_POLYGON_OFFSET_UNITS), vtkOITName(GL_SAMPLE_COVERAGE_VALUE) };

const Name Drawing[] = { vtkOITName(GL_CURRENT_PROGRAM), vtkOITName(GL_VERTEX_ARRAY_BINDING),
  vtkOITName(GL_ARRAY_BUFFER_BINDING) };

// Every binding point of these, up to 8.
const Name IndexedBindings[] = { vtkOITName(GL_SHADER_STORAGE_BUFFER_BINDING),
  vtkOITName(GL_SHADER_STORAGE_BUFFER_START), vtkOITName(GL_SHADER_STORAGE_BUFFER_SIZE),
  vtkOITName(GL_UNIFORM_BUFFER_BINDING), vtkOITName(GL_ATOMIC_COUNTER_BUFFER_BINDING),
  vtkOITName(GL_ATOMIC_COUNTER_BUFFER_START), vtkOITName(GL_ATOMIC_COUNTER_BUFFER_SIZE) };
const Name ImageBindings[] = { vtkOITName(GL_IMAGE_BINDING_NAME),
  vtkOITName(GL_IMAGE_BINDING_LEVEL), vtkOITName(GL_IMAGE_BINDING_LAYERED),
  vtkOITName(GL_IMAGE_BINDING_LAYER), vtkOITName(GL_IMAGE_BINDING_ACCESS),
  vtkOITName(GL_IMAGE_BINDING_FORMAT) };

std::string GetIntegers(GLenum name)
{
  GLint values[4] = { 0, 0, 0, 0 };
  glGetIntegerv(name, values);
  std::ostringstream text;
  text << values[0] << " " << values[1] << " " << values[2] << " " << values[3];
  return text.str();
}

GLint GetLimit(GLenum name)
{
  GLint limit = 0;
  glGetIntegerv(name, &limit);
  return limit < 8 ? limit : 8;
}

std::string Indexed(const char* name, int index)
{
  return std::string(name) + "[" + std::to_string(index) + "]";
}
}

//------------------------------------------------------------------------------
GLStateSnapshot GLStateSnapshot::Take(Extent extent)
{
  GLStateSnapshot snapshot;
  for (const Name& name : Capabilities)
  {
    snapshot.Values[name.Text] = glIsEnabled(name.Value) ? "enabled" : "disabled";
  }
  for (const Name& name : Integers)
  {
    snapshot.Values[name.Text] = GetIntegers(name.Value);
  }
  for (const Name& name : Floats)
  {
    GLfloat values[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
    glGetFloatv(name.Value, values);
    std::ostringstream text;
    text << values[0] << " " << values[1] << " " << values[2] << " " << values[3];
    snapshot.Values[name.Text] = text.str();
  }
  for (int i = 0; i < 6; ++i)
  {
    snapshot.Values[Indexed("GL_CLIP_DISTANCE", i)] =
      glIsEnabled(GL_CLIP_DISTANCE0 + i) ? "enabled" : "disabled";
  }
  for (int i = 0, end = GetLimit(GL_MAX_DRAW_BUFFERS); i < end; ++i)
  {
    snapshot.Values[Indexed("GL_DRAW_BUFFER", i)] = GetIntegers(GL_DRAW_BUFFER0 + i);
    GLboolean mask[4] = { GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE };
    glGetBooleani_v(GL_COLOR_WRITEMASK, i, mask);
    std::ostringstream text;
    text << int(mask[0]) << int(mask[1]) << int(mask[2]) << int(mask[3]);
    snapshot.Values[Indexed("GL_COLOR_WRITEMASK", i)] = text.str();
  }
  for (const Name& name : IndexedBindings)
  {
    // One atomic counter binding is all that llvmpipe promises.
    const bool atomic = std::string(name.Text).find("ATOMIC") != std::string::npos;
    const int end = atomic ? GetLimit(GL_MAX_ATOMIC_COUNTER_BUFFER_BINDINGS)
                           : GetLimit(GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS);
    for (int i = 0; i < end; ++i)
    {
      GLint64 value = 0;
      glGetInteger64i_v(name.Value, i, &value);
      snapshot.Values[Indexed(name.Text, i)] = std::to_string(value);
    }
  }
  for (const Name& name : ImageBindings)
  {
    for (int i = 0, end = GetLimit(GL_MAX_IMAGE_UNITS); i < end; ++i)
    {
      GLint value = 0;
      glGetIntegeri_v(name.Value, i, &value);
      snapshot.Values[Indexed(name.Text, i)] = std::to_string(value);
    }
  }
  // Those of the active unit are anybody's; others are kept.
  const GLint active = []
  {
    GLint unit = 0;
    glGetIntegerv(GL_ACTIVE_TEXTURE, &unit);
    return unit;
  }();
  for (int unit = 12; unit < 16; ++unit)
  {
    glActiveTexture(GL_TEXTURE0 + unit);
    for (const GLenum name : { GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_2D_ARRAY,
           GL_TEXTURE_BINDING_BUFFER, GL_SAMPLER_BINDING })
    {
      snapshot.Values[Indexed("binding of texture unit", unit) + std::to_string(name)] =
        GetIntegers(name);
    }
  }
  glActiveTexture(active);
  for (const GLenum target : { GL_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED, GL_TIME_ELAPSED })
  {
    GLint query = 0;
    glGetQueryiv(target, GL_CURRENT_QUERY, &query);
    snapshot.Values["query of target " + std::to_string(target)] = std::to_string(query);
  }
  if (extent == WithDrawing)
  {
    for (const Name& name : Drawing)
    {
      snapshot.Values[name.Text] = GetIntegers(name.Value);
    }
  }
  const GLenum error = glGetError();
  snapshot.Values["glGetError"] = std::to_string(error);
  return snapshot;
}

//------------------------------------------------------------------------------
std::vector<std::string> GLStateSnapshot::FindChanges(const GLStateSnapshot& after) const
{
  std::vector<std::string> changes;
  for (const auto& value : this->Values)
  {
    const std::string& now = after.Values.at(value.first);
    if (now != value.second)
    {
      changes.push_back(value.first + ": " + value.second + " -> " + now);
    }
  }
  return changes;
}

//------------------------------------------------------------------------------
std::vector<std::string> GLStateSnapshot::FindStaleCache(vtkOpenGLState* state)
{
  std::vector<std::string> stale;
  for (const GLenum capability :
    { GL_BLEND, GL_DEPTH_TEST, GL_SCISSOR_TEST, GL_CULL_FACE, GL_MULTISAMPLE })
  {
    if (state->GetEnumState(capability) != (glIsEnabled(capability) == GL_TRUE))
    {
      stale.push_back("capability " + std::to_string(capability));
    }
  }
  GLint is[4];
  GLint cached[4];
  for (const GLenum name : { GL_VIEWPORT, GL_SCISSOR_BOX })
  {
    glGetIntegerv(name, is);
    state->vtkglGetIntegerv(name, cached);
    if (is[0] != cached[0] || is[1] != cached[1] || is[2] != cached[2] || is[3] != cached[3])
    {
      stale.push_back(name == GL_VIEWPORT ? "viewport" : "scissor box");
    }
  }
  int function[4];
  state->GetBlendFuncState(function);
  const GLenum names[4] = { GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA,
    GL_BLEND_DST_ALPHA };
  for (int i = 0; i < 4; ++i)
  {
    glGetIntegerv(names[i], is);
    if (is[0] != function[i])
    {
      stale.push_back("blend function " + std::to_string(i));
    }
  }
  GLboolean mask = GL_FALSE;
  glGetBooleanv(GL_DEPTH_WRITEMASK, &mask);
  GLboolean cachedMask = GL_FALSE;
  state->vtkglGetBooleanv(GL_DEPTH_WRITEMASK, &cachedMask);
  if (cachedMask != mask)
  {
    stale.push_back("depth mask");
  }
  return stale;
}
}
