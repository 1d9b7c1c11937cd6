// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITABufferPass.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkOITABufferPass);

vtkOITABufferPass::vtkOITABufferPass() = default;

vtkOITABufferPass::~vtkOITABufferPass() = default;
