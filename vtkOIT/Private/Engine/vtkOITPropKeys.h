// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITPropKeys_h
#define vtkOITPropKeys_h

class vtkOpenGLRenderPass;
class vtkRenderState;

/// While one lives, a pass is among those that are asked about the shaders of the state's props.
class vtkOITPropKeys
{
public:
  vtkOITPropKeys(const vtkRenderState* state, vtkOpenGLRenderPass* pass);
  ~vtkOITPropKeys();
  vtkOITPropKeys(const vtkOITPropKeys&) = delete;
  vtkOITPropKeys& operator=(const vtkOITPropKeys&) = delete;

private:
  const vtkRenderState* State;
  vtkOpenGLRenderPass* Pass;
};

#endif
