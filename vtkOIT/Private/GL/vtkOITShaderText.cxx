// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/GL/vtkOITShaderText.h"

#include "Private/Frame/vtkOITCompatibility.h"

#include "vtkOITConstantsText.h"

#include <algorithm>
#include <cstdio>
#include <regex>
#include <set>
#include <sstream>

namespace
{
constexpr const char* Top = "//VTK::System::Dec";
constexpr const char* InPlaceOfTop = "//VTK::OIT::System::Dec";
constexpr const char* OITShade = "void oitShade()";

/// Extensions whose specifications are written against a later GLSL than VTK's 1.50, and the one
/// that strict compilers ask for: Khronos's glslangValidator refuses them in an earlier one.
constexpr struct
{
  const char* Extension;
  int Version;
} Versions[] = { { "GL_ARB_shader_image_load_store", 420 },
  { "GL_ARB_shading_language_420pack", 420 }, { "GL_ARB_shader_storage_buffer_object", 430 },
  { "GL_ARB_derivative_control", 450 }, { "GL_ARB_fragment_shader_interlock", 450 },
  { "GL_ARB_post_depth_coverage", 450 } };

/// What VTK puts below its own version for the texts of applications, which may be of any age.
constexpr const char* Synonyms = "#define highp\n#define mediump\n#define lowp\n"
                                 "#define texelFetchBuffer texelFetch\n#define texture1D texture\n"
                                 "#define texture2D texture\n#define texture3D texture\n"
                                 "#define varying in\n";

/// GLSL of the current context: 150, 450.
int FindSupportedVersion()
{
  const auto* text = reinterpret_cast<const char*>(glGetString(GL_SHADING_LANGUAGE_VERSION));
  int major = 0;
  int minor = 0;
  return text && std::sscanf(text, "%d.%d", &major, &minor) == 2 ? 100 * major + minor : 0;
}

/// Every `from`.
void Replace(std::string& text, const std::string& from, const std::string& to)
{
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at))
  {
    text.replace(at, from.size(), to);
    at += to.size();
  }
}

/// Without comments but marks, and without empty lines: VTK looks through the text, and takes its digest,
/// for each prop.
std::string Shorten(const std::string& text)
{
  std::string shorter;
  std::istringstream lines(text);
  std::string line;
  while (std::getline(lines, line))
  {
    const bool isMark = line.compare(0, 7, "//VTK::") == 0;
    line.resize(isMark ? line.size() : std::min(line.size(), line.find("//")));
    if (line.find_first_not_of(' ') != std::string::npos)
    {
      shorter += line + "\n";
    }
  }
  return shorter;
}

/// A shader that discards makes llvmpipe blend pixels which failed the early depth test, too; one
/// that leaves a fragment without opacity does not. Only in main() itself, where `return` can stand
/// for `discard`.
void ReplaceDiscard(std::string& shader)
{
  const std::size_t begin = shader.find('{', shader.find(OITShade));
  std::size_t end = begin;
  int depth = 0;
  for (; end < shader.size(); ++end)
  {
    depth += shader[end] == '{' ? 1 : shader[end] == '}' ? -1 : 0;
    if (depth == 0)
    {
      break;
    }
  }
  static const std::regex discard(R"(\bdiscard\s*;)");
  shader = shader.substr(0, begin) +
    std::regex_replace(
      shader.substr(begin, end - begin), discard, "{ oitFragColor = vec4(0.0); return; }") +
    shader.substr(end);
}

/// What mappers and other passes write: the first colour becomes oitFragColor, all others variables,
/// whose declarations are returned. VTK names an output gl_FragData[i], and fragOutputI once it has
/// looked at the text; others may have declared outputs of their own.
std::string ReplaceOutputs(std::string& shader)
{
  std::string variables = "vec4 oitFragColor;\n";
  Replace(shader, "gl_FragData[0]", "oitFragColor");
  Replace(shader, "fragOutput0", "oitFragColor");
  static const std::regex numbered(R"((?:gl_FragData\[\s*(\d+)\s*\]|\bfragOutput(\d+)\b))");
  std::set<std::string> numbers;
  for (std::sregex_iterator it(shader.begin(), shader.end(), numbered), end; it != end; ++it)
  {
    numbers.insert((*it)[1].matched ? (*it)[1].str() : (*it)[2].str());
  }
  if (!numbers.empty())
  {
    shader = std::regex_replace(shader, numbered, "oitFragData$1$2");
  }
  for (const std::string& number : numbers)
  {
    variables += "vec4 oitFragData" + number + ";\n";
  }
  static const std::regex declared(
    R"((^|\n)[ \t]*(?:layout\s*\([^)]*\)\s*)?out\s+((?:[a-z]+p\s+)?\w+\s+\w+\s*;))");
  shader = std::regex_replace(shader, declared, "$1$2");
  return variables;
}
}

//------------------------------------------------------------------------------
vtkOITShaderText::vtkOITShaderText(std::initializer_list<const char*> files)
{
  for (const char* file : files)
  {
    this->Stage += file;
  }
}

//------------------------------------------------------------------------------
vtkOITShaderText& vtkOITShaderText::Require(std::initializer_list<const char*> extensions)
{
  for (const char* name : extensions)
  {
    if (!this->Requires(name))
    {
      this->Extensions.emplace_back(name);
    }
  }
  return *this;
}

//------------------------------------------------------------------------------
bool vtkOITShaderText::Requires(const char* extension) const
{
  return std::find(this->Extensions.begin(), this->Extensions.end(), extension) !=
    this->Extensions.end();
}

//------------------------------------------------------------------------------
vtkOITShaderText& vtkOITShaderText::Define(const char* name, bool isDefined)
{
  this->Definitions += isDefined ? "#define " + std::string(name) + "\n" : "";
  return *this;
}

//------------------------------------------------------------------------------
vtkOITShaderText& vtkOITShaderText::Define(const char* name, int value)
{
  this->Definitions += "#define " + std::string(name) + " " + std::to_string(value) + "\n";
  return *this;
}

//------------------------------------------------------------------------------
vtkOITShaderText& vtkOITShaderText::Declare(const std::string& line)
{
  this->Declarations += line + "\n";
  return *this;
}

//------------------------------------------------------------------------------
vtkOITShaderText& vtkOITShaderText::Insert(const char* place, const std::string& text)
{
  Replace(this->Stage, std::string("//VTK::OIT::") + place + "\n", text + "\n");
  return *this;
}

//------------------------------------------------------------------------------
vtkOITShaderText& vtkOITShaderText::InsertRepeated(const char* place, const char* macro, int count)
{
  std::string text;
  for (int i = 0; i < count; ++i)
  {
    text += std::string(macro) + "(" + std::to_string(i) + ")\n";
  }
  return this->Insert(place, text);
}

//------------------------------------------------------------------------------
vtkOITShaderText& vtkOITShaderText::TestDepthEarly()
{
  this->EarlyTests = true;
  return *this;
}

//------------------------------------------------------------------------------
vtkOITShaderText& vtkOITShaderText::ReadPrimitives()
{
  this->PrimitivesRead = true;
  return *this;
}

//------------------------------------------------------------------------------
// An earlier version than the extensions ask for, where the context has no other: the drivers that
// offer them there take them there.
std::string vtkOITShaderText::GetTop(bool testsDepthEarly, bool writesDepth) const
{
  int version = 0;
  for (const auto& needed : Versions)
  {
    version = this->Requires(needed.Extension) ? std::max(version, needed.Version) : version;
  }
  const bool hasVersion = version > 0 && FindSupportedVersion() >= version;
  std::string text =
    hasVersion ? "#version " + std::to_string(version) + "\n" + Synonyms : std::string(Top) + "\n";
  for (const std::string& name : this->Extensions)
  {
    text += "#extension " + name + " : require\n";
  }
  text += std::string(vtkOITConstantsText) + "\n";
  text += writesDepth ? "#define OIT_WRITES_DEPTH\n" : "";
  text += this->Definitions + this->Declarations;
  text += testsDepthEarly ? "layout(early_fragment_tests) in;\n" : "";
  text += hasVersion ? std::string(InPlaceOfTop) + "\n" : "";
  return text;
}

//------------------------------------------------------------------------------
std::string vtkOITShaderText::GetText() const
{
  std::string text = this->Stage;
  Replace(text, Top, this->GetTop(this->EarlyTests, false));
  return text;
}

//------------------------------------------------------------------------------
bool vtkOITShaderText::Wrap(std::string& mapperShader) const
{
  static const std::regex mainFunction(R"(\bvoid\s+main\s*\(\s*(void)?\s*\))");
  if (!std::regex_search(mapperShader, mainFunction))
  {
    return false;
  }
  const bool writesDepth = vtkOITWritesDepth(mapperShader);
  mapperShader = std::regex_replace(mapperShader, mainFunction, OITShade);
  ReplaceDiscard(mapperShader);
  const std::string variables = ReplaceOutputs(mapperShader);
  Replace(mapperShader, Top,
    Shorten(this->GetTop(this->EarlyTests && !writesDepth, writesDepth)) + variables);
  mapperShader += "\n" + Shorten(this->Stage);
  return true;
}

//------------------------------------------------------------------------------
void vtkOITReplaceTop(std::string& shader, const std::function<void(std::string& top)>& replaceMore)
{
  if (shader.find(InPlaceOfTop) != std::string::npos)
  {
    std::string top = Top;
    replaceMore(top);
    Replace(top, Top, "");
    Replace(shader, InPlaceOfTop, top);
  }
}

//------------------------------------------------------------------------------
bool vtkOITShaderText::operator==(const vtkOITShaderText& other) const
{
  return this->Extensions == other.Extensions && this->Definitions == other.Definitions &&
    this->Declarations == other.Declarations && this->Stage == other.Stage &&
    this->EarlyTests == other.EarlyTests && this->PrimitivesRead == other.PrimitivesRead;
}

//------------------------------------------------------------------------------
void vtkOITHandOnPrimitives(std::string& geometryShader)
{
  static const std::regex emit(R"(\bEmitVertex\s*\(\s*\)\s*;)");
  if (geometryShader.find("gl_PrimitiveID =") == std::string::npos)
  {
    geometryShader =
      std::regex_replace(geometryShader, emit, "{ gl_PrimitiveID = gl_PrimitiveIDIn; $& }");
  }
}

//------------------------------------------------------------------------------
bool vtkOITWritesDepth(const std::string& fragmentShader)
{
  // VTK's template names gl_FragDepth in a comment.
  std::istringstream lines(fragmentShader);
  std::string line;
  while (std::getline(lines, line))
  {
    if (line.substr(0, line.find("//")).find("gl_FragDepth") != std::string::npos)
    {
      return true;
    }
  }
  return false;
}
