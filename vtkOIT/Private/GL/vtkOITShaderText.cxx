// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/GL/vtkOITShaderText.h"

#include <regex>
#include <sstream>

namespace
{
constexpr const char* OITShade = "void oitShade()";

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

/// Batcher's odd-even merge sort, as compare-exchanges of registers. For sizes that are no power of
/// two it is the network of the next one without the exchanges beyond the size, where nothing that
/// sorts before could be.
void WriteSortingNetwork(std::ostream& os, int size)
{
  for (int p = 1; p < size; p *= 2)
  {
    for (int k = p; k >= 1; k /= 2)
    {
      for (int j = k % p; j + k < size; j += 2 * k)
      {
        for (int i = j; i < j + k && i + k < size; ++i)
        {
          if (i / (2 * p) == (i + k) / (2 * p))
          {
            os << "OIT_COMPARE_EXCHANGE(" << i << ", " << i + k << ")\n";
          }
        }
      }
    }
  }
}

/// The macro for each of the registers from `first` up to `end`.
void WriteForEach(std::ostream& os, const char* macro, int first, int end)
{
  for (int i = first; i < end; ++i)
  {
    os << macro << "(" << i << ")\n";
  }
}

void WriteTies(std::ostream& os, int size)
{
  for (int i = 0; i + 1 < size; ++i)
  {
    os << "OIT_NOTE_TIE(" << i << ", " << i + 1 << ")\n";
  }
}
}

//------------------------------------------------------------------------------
std::string vtkOITRequireExtensions(std::initializer_list<const char*> names)
{
  std::string text;
  for (const char* name : names)
  {
    text += std::string("#extension ") + name + " : require\n";
  }
  return text;
}

//------------------------------------------------------------------------------
std::string vtkOITRepeat(const char* macro, int count)
{
  std::string text;
  for (int i = 0; i < count; ++i)
  {
    text += std::string(macro) + "(" + std::to_string(i) + ")\n";
  }
  return text;
}

//------------------------------------------------------------------------------
bool vtkOITReplace(std::string& text, const std::string& from, const std::string& to)
{
  bool found = false;
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at))
  {
    text.replace(at, from.size(), to);
    at += to.size();
    found = true;
  }
  return found;
}

//------------------------------------------------------------------------------
bool vtkOITWrapFragmentShader(
  std::string& shader, const std::string& header, const std::string& stage)
{
  static const std::regex mainFunction(R"(\bvoid\s+main\s*\(\s*(void)?\s*\))");
  if (!std::regex_search(shader, mainFunction))
  {
    return false;
  }
  shader = std::regex_replace(shader, mainFunction, OITShade);
  ReplaceDiscard(shader);
  vtkOITReplace(shader, "gl_FragData[0]", "oitFragColor");
  vtkOITReplace(shader, "fragOutput0", "oitFragColor");
  vtkOITReplace(
    shader, "//VTK::System::Dec", "//VTK::System::Dec\n" + header + "vec4 oitFragColor;\n");
  shader += "\n" + stage;
  return true;
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

//------------------------------------------------------------------------------
std::string vtkOITRegisterResolve(int size)
{
  std::ostringstream os;
  WriteForEach(os, "OIT_DECLARE", 0, size);
  WriteForEach(os, "OIT_LOAD", 0, size);
  WriteSortingNetwork(os, size);
  WriteTies(os, size);
  WriteForEach(os, "OIT_BLEND", 0, size);
  return os.str();
}

//------------------------------------------------------------------------------
std::string vtkOITRegisterSelect(int size, int kept)
{
  std::ostringstream os;
  WriteForEach(os, "OIT_DECLARE", 0, size);
  os << "do\n{\nif (count == 0u)\n{\n";
  WriteForEach(os, "OIT_LOAD", 0, kept);
  os << "}\n";
  WriteForEach(os, "OIT_LOAD", kept, size);
  WriteSortingNetwork(os, size);
  os << "thin = 1.0;\n";
  WriteForEach(os, "OIT_THIN", 0, kept - 1);
  os << "} while (node != OIT_END && (count < " << size << "u || thin <= oitThreshold));\n"
     << "isLong = count > " << size << "u;\n";
  WriteForEach(os, "OIT_FORGET", kept, size);
  WriteTies(os, size);
  WriteForEach(os, "OIT_BLEND", 0, size);
  return os.str();
}

//------------------------------------------------------------------------------
std::string vtkOITRegisterSort(int size)
{
  std::ostringstream os;
  WriteForEach(os, "OIT_LOAD", 0, size);
  WriteSortingNetwork(os, size);
  os << "OITFragment last = f0;\n";
  WriteForEach(os, "OIT_LINK", 0, size);
  return os.str();
}
