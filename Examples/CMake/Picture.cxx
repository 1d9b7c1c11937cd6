// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

#include <vtkOITABufferPass.h>
#include <vtkOITHeadless.h>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkConeSource.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

#include <iostream>

namespace
{
void AddGlass(vtkRenderer* renderer, vtkAlgorithm* source, double r, double g, double b)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(r, g, b);
  actor->GetProperty()->SetOpacity(0.5);
  renderer->AddActor(actor);
}
}

bool WritePicture(const std::string& fileName)
{
  if (!vtkOITHeadless::Initialize())
  {
    return false;
  }

  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkConeSource> cone;
  cone->SetResolution(32);
  cone->SetDirection(0.0, 1.0, 0.0);
  AddGlass(renderer, cone, 0.9, 0.6, 0.1);
  vtkNew<vtkPlaneSource> plate;
  AddGlass(renderer, plate, 0.2, 0.5, 0.9);

  // As part of a chain of render passes: the application decides about every step.
  vtkNew<vtkOITABufferPass> translucent;
  vtkNew<vtkRenderStepsPass> steps;
  steps->SetTranslucentPass(translucent);
  renderer->SetPass(steps);

  vtkNew<vtkRenderWindow> window;
  window->SetSize(400, 300);
  window->AddRenderer(renderer);
  renderer->ResetCamera();
  renderer->GetActiveCamera()->Azimuth(30.0);
  window->Render();
  if (!translucent->GetExact())
  {
    std::cerr << "Picture: the frame is not exact\n";
    return false;
  }

  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(image->GetOutputPort());
  writer->SetFileName(fileName.c_str());
  writer->Write();
  return writer->GetErrorCode() == 0;
}
