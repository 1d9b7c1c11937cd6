// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITShaderText_h
#define vtkOITShaderText_h

#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

/**
 * The text of a stage, put together from GLSL files: what stands at the top (extensions,
 * definitions, the constants that C++ and GLSL share), and the parts that are inserted at places
 * `//VTK::OIT::Name` of the file.
 *
 * GetText() is for stages on pixels, whose files have a `//VTK::System::Dec`; Wrap() for stages on
 * fragments of props, which are made from the mapper's own shader.
 */
class vtkOITShaderText
{
public:
  vtkOITShaderText(std::initializer_list<const char*> files);

  /// Asks for extensions by name, and for the GLSL version that they are written against, where the
  /// current context has it.
  vtkOITShaderText& Require(std::initializer_list<const char*> extensions);
  /// `#define name value`, when `isDefined`.
  ///@{
  vtkOITShaderText& Define(const char* name, bool isDefined = true);
  vtkOITShaderText& Define(const char* name, int value);
  ///@}
  /// A line for the top that is no definition, after those.
  vtkOITShaderText& Declare(const std::string& line);
  /// In place of `//VTK::OIT::place`.
  vtkOITShaderText& Insert(const char* place, const std::string& text);
  /// Lines `macro(0)`, `macro(1)` and so on in place of `//VTK::OIT::place`.
  vtkOITShaderText& InsertRepeated(const char* place, const char* macro, int count);
  /// The depth test runs before the shader, wherever the mapper's shader does not write gl_FragDepth:
  /// where it would not by itself because the shader reads the framebuffer, or has side effects.
  vtkOITShaderText& TestDepthEarly();

  /// The stage reads gl_PrimitiveID, which a geometry shader must hand on.
  vtkOITShaderText& ReadPrimitives();
  bool ReadsPrimitives() const { return this->PrimitivesRead; }

  /// The fragment or vertex shader of a stage on pixels.
  std::string GetText() const;

  /**
   * Turns the main() of a mapper's fragment shader into `void oitShade()`, its colour output into
   * the variable `vec4 oitFragColor`, and appends this stage, which must bring a new main().
   * Its other outputs, those of passes around ours included, become variables that nobody reads.
   * OIT_WRITES_DEPTH is defined where the mapper's shader writes gl_FragDepth. Works with any
   * shader text, also an application's own, because it relies on none of VTK's substitution sites
   * inside of main(). False when there is no main().
   */
  bool Wrap(std::string& mapperShader) const;

  bool operator==(const vtkOITShaderText& other) const;

private:
  bool Requires(const char* extension) const;
  std::string GetTop(bool testsDepthEarly, bool writesDepth) const;

  std::vector<std::string> Extensions;
  std::string Definitions;
  std::string Declarations;
  std::string Stage;
  bool EarlyTests = false;
  bool PrimitivesRead = false;
};

/// Where a wrapped shader has a version of its own, VTK's `//VTK::System::Dec` is gone. What others
/// would replace there later, they replace in `top`, and it gets where it belongs.
void vtkOITReplaceTop(
  std::string& shader, const std::function<void(std::string& top)>& replaceMore);

/// Hands gl_PrimitiveID on to the fragment shader: undefined otherwise. Nothing to do without a shader.
void vtkOITHandOnPrimitives(std::string& geometryShader);

/// True when the shader assigns gl_FragDepth.
bool vtkOITWritesDepth(const std::string& fragmentShader);

#endif
