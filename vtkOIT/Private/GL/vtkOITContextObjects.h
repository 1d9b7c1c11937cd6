// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITContextObjects_h
#define vtkOITContextObjects_h

#include "vtkSmartPointer.h"

class vtkOpenGLRenderWindow;
class vtkTextureObject;

/**
 * Ties GL objects, made with plain GL calls, to the context of a window: says whether that context
 * still exists, and makes it current for deleting them.
 *
 * VTK tells its own classes when a window releases its resources, by a callback whose header is
 * not installed before VTK 9.4. A texture of one texel serves as the marker instead: VTK resets
 * its handle at that moment.
 */
class vtkOITContextObjects
{
public:
  vtkOITContextObjects();
  virtual ~vtkOITContextObjects();
  vtkOITContextObjects(const vtkOITContextObjects&) = delete;
  vtkOITContextObjects& operator=(const vtkOITContextObjects&) = delete;

  /// Deletes the objects, in their own context, if that still exists. A derived class must call
  /// it in its destructor.
  void Release();

  /// The window whose context has the objects; nullptr when there are none, or no longer.
  vtkOpenGLRenderWindow* GetWindow() const;

protected:
  /// To be called before objects are made or used: releases those of another window, and forgets
  /// those that vanished with their context. True when nothing had to be released or forgotten.
  bool Attach(vtkOpenGLRenderWindow* window);

  /// glDelete* what there is. The context is current.
  virtual void Delete() = 0;
  /// Sets all names and sizes to 0.
  virtual void Forget() = 0;

private:
  vtkSmartPointer<vtkTextureObject> Marker;
};

#endif
