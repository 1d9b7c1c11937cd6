// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITShaderText_h
#define vtkOITShaderText_h

#include <initializer_list>
#include <string>

/// Lines `#extension NAME : require`.
std::string vtkOITRequireExtensions(std::initializer_list<const char*> names);

/// Replaces every `from`; true when there was one.
bool vtkOITReplace(std::string& text, const std::string& from, const std::string& to);

/// Lines `macro(0)`, `macro(1)` and so on.
std::string vtkOITRepeat(const char* macro, int count);

/**
 * Turns the main() of a VTK fragment shader into `void oitShade()`, its colour output into the
 * variable `vec4 oitFragColor`, and appends `stage`, which must bring a new main(). `header` goes
 * to the top, after #version. Works with any shader text, also an application's own, because it
 * relies on none of VTK's substitution sites inside of main(). False when there is no main().
 */
bool vtkOITWrapFragmentShader(
  std::string& shader, const std::string& header, const std::string& stage);

/// True when the shader assigns gl_FragDepth.
bool vtkOITWritesDepth(const std::string& fragmentShader);

/**
 * The text `//VTK::OIT::Registers` of vtkOITABufferResolveFS.glsl: loads, sorts and blends up
 * to `size` fragments in registers.
 */
std::string vtkOITRegisterResolve(int size);

/**
 * The text `//VTK::OIT::Registers` of vtkOITABufferSecondChanceFS.glsl: loads, sorts and blends
 * up to `size` fragments in registers; of more, the `kept` nearest, while those behind are not
 * seen.
 */
std::string vtkOITRegisterSelect(int size, int kept);

/// The text `//VTK::OIT::SortRun` of vtkOITABufferSortFS.glsl: loads, sorts and links `size`
/// nodes.
std::string vtkOITRegisterSort(int size);

#endif
