// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITPass.h"

#include "vtkRenderState.h"
#include "vtkTranslucentPass.h"

vtkOITPass::vtkOITPass()
{
  this->TranslucentPass = vtkSmartPointer<vtkTranslucentPass>::New();
}

vtkOITPass::~vtkOITPass() = default;

void vtkOITPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

void vtkOITPass::Render(const vtkRenderState* state)
{
  this->TranslucentPass->Render(state);
}

void vtkOITPass::SetTranslucentPass(vtkRenderPass* pass)
{
  this->TranslucentPass = pass;
}

vtkRenderPass* vtkOITPass::GetTranslucentPass()
{
  return this->TranslucentPass;
}

void vtkOITPass::SetMaximumBufferSize(vtkTypeInt64 bytes)
{
  this->MaximumBufferSize = bytes;
}
