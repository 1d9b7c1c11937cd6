// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The smallest program: three translucent spheres inside each other, in the right order from
 * every side, drawn without a display into the PNG file named on the command line.
 */
#include <vtkOITABufferPass.h>
#include <vtkOITHeadless.h>
#include <vtkOITRendererHook.h>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkWindowToImageFilter.h>

#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "usage: TranslucentSpheres FILE.png\n";
    return 2;
  }
  // Leave this out to draw into a window on the screen.
  if (!vtkOITHeadless::Initialize())
  {
    return 1;
  }

  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  const double colors[3][3] = { { 0.8, 0.2, 0.2 }, { 0.2, 0.7, 0.3 }, { 0.2, 0.3, 0.9 } };
  for (int i = 0; i < 3; ++i)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(1.0 + 0.5 * i);
    sphere->SetCenter(0.4 * i, 0.0, 0.0);
    sphere->SetThetaResolution(64);
    sphere->SetPhiResolution(64);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(sphere->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(colors[i][0], colors[i][1], colors[i][2]);
    actor->GetProperty()->SetOpacity(0.4);
    renderer->AddActor(actor);
  }

  // The only line that an existing program needs.
  vtkNew<vtkOITABufferPass> pass;
  if (!vtkOITRendererHook::Install(renderer, pass))
  {
    return 1;
  }

  vtkNew<vtkRenderWindow> window;
  window->SetSize(400, 400);
  window->AddRenderer(renderer);
  window->Render();

  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(image->GetOutputPort());
  writer->SetFileName(argv[1]);
  writer->Write();
  return writer->GetErrorCode() == 0 ? 0 : 1;
}
