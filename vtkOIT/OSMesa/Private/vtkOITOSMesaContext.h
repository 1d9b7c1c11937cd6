// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * One OpenGL context of OSMesa: core profile, the highest version that the library gives.
 *
 * Its default framebuffer is a single pixel. VTK draws into framebuffer objects of its own, so a
 * full-size one would only be memory that is filled and copied on every frame.
 */

#ifndef vtkOITOSMesaContext_h
#define vtkOITOSMesaContext_h

#include "Private/vtkOITOSMesaLibrary.h"

#include <array>
#include <memory>
#include <string>

class vtkOITOSMesaContext
{
public:
  /**
   * A new context that shares textures and buffers with `share` when that is not null. On failure
   * the result is null and `error` holds one line that names the reason.
   */
  static std::unique_ptr<vtkOITOSMesaContext> Create(
    const vtkOITOSMesaContext* share, std::string& error);
  ~vtkOITOSMesaContext();

  /**
   * Why no context works in this process, one line: it was forked after Mesa had started its threads
   * in the parent. Empty otherwise. Contexts of the parent must not be touched then.
   */
  static std::string FindLossByFork();

  /// Does nothing when it is current already. False when OSMesa refuses.
  bool MakeCurrent();
  bool IsCurrent() const;
  /// The OSMesaContext.
  void* GetHandle() const { return this->Handle; }

  /// What is current in this thread, whoever made it, to be made current again later.
  struct Binding
  {
    vtkOITOSMesaLibrary::Handle Handle = nullptr;
    bool Ours = false;
    void* Buffer = nullptr;
    int Width = 0;
    int Height = 0;
  };
  static Binding GetBinding();
  /// A context that was destroyed in between is left alone; so is the absence of one.
  static void Restore(const Binding& binding);

private:
  explicit vtkOITOSMesaContext(vtkOITOSMesaLibrary::Handle handle);
  vtkOITOSMesaContext(const vtkOITOSMesaContext&) = delete;
  void operator=(const vtkOITOSMesaContext&) = delete;

  vtkOITOSMesaLibrary::Handle Handle;
  std::array<unsigned char, 4> Pixel{};
};

#endif
