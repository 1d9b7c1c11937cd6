// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The picture is the same however a window is asked to show itself, with and without multisampling,
// and whichever way it is read.
#include "HeadlessTest.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkWindowToImageFilter.h"

#include <cmath>

using namespace HeadlessTest;

namespace
{
const Colour Quad = { 255, 102, 0 };
const Colour Background = { 0, 51, 153 };

//------------------------------------------------------------------------------
void CheckReading(vtkRenderWindow* window, const std::string& what)
{
  CheckScene(window, Quad, Background, what);
  Check(GetPixel(window, 40, 30, 0) == Quad, what + ": back buffer");

  vtkNew<vtkFloatArray> rgba;
  Check(
    window->GetRGBAPixelData(40, 30, 40, 30, 1, rgba) == VTK_OK && rgba->GetNumberOfValues() == 4,
    what + ": GetRGBAPixelData");
  Check(std::abs(rgba->GetValue(1) - 0.4f) < 1e-3f, what + ": RGBA value");

  vtkNew<vtkUnsignedCharArray> bytes;
  Check(window->GetRGBACharPixelData(0, 0, 79, 59, 1, bytes) == VTK_OK &&
      bytes->GetNumberOfValues() == 4 * 80 * 60,
    what + ": GetRGBACharPixelData");
  Check(bytes->GetValue(2) == Background[2], what + ": RGBA bytes");

  vtkNew<vtkFloatArray> depth;
  Check(window->GetZbufferData(0, 0, 79, 59, depth) == VTK_OK, what + ": GetZbufferData");
  Check(depth->GetValue(0) == 1.0f && depth->GetValue(30 * 80 + 40) < 1.0f, what + ": depth");

  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->SetInputBufferTypeToRGB();
  grab->Update();
  vtkImageData* image = grab->GetOutput();
  Check(image->GetDimensions()[0] == 80 && image->GetDimensions()[1] == 60, what + ": image size");
  Check(image->GetScalarComponentAsDouble(40, 30, 0, 1) == Quad[1], what + ": image");
}

//------------------------------------------------------------------------------
void CheckVariant(bool show, bool offScreen, int samples, bool doubleBuffer)
{
  const std::string what = std::string("ShowWindow ") + (show ? "on" : "off") +
    ", UseOffScreenBuffers " + (offScreen ? "on" : "off") + ", MultiSamples " +
    std::to_string(samples) + ", DoubleBuffer " + (doubleBuffer ? "on" : "off");
  vtkNew<vtkRenderWindow> window;
  window->SetShowWindow(show);
  window->SetUseOffScreenBuffers(offScreen);
  window->SetMultiSamples(samples);
  window->SetDoubleBuffer(doubleBuffer);
  window->SetSize(80, 60);
  window->AddRenderer(MakeScene(Quad, Background));
  window->Render();
  CheckReading(window, what);
  window->SetMultiSamples(samples ? 0 : 4);
  window->SetUseOffScreenBuffers(!offScreen);
  window->Render();
  CheckReading(window, what + ", then the reverse");
}
}

int main()
{
  if (!vtkOITHeadless::Initialize())
  {
    return EXIT_FAILURE;
  }
  const bool own = HasOwnWindow();
  for (const int samples : { 0, 4 })
  {
    for (const bool offScreen : { false, true })
    {
      CheckVariant(false, offScreen, samples, false);
      if (own) // VTK's own headless windows are not promised to take these
      {
        CheckVariant(true, offScreen, samples, false);
        CheckVariant(false, offScreen, samples, true);
      }
    }
  }
  if (own)
  {
    vtkNew<vtkRenderWindow> window;
    window->SetOffScreenRendering(1);
    window->SetFullScreen(1);
    window->StereoCapableWindowOn();
    window->SetStereoTypeToCrystalEyes();
    window->StereoRenderOn();
    window->SetSize(80, 60);
    window->AddRenderer(MakeScene(Quad, Background));
    window->Render();
    // The eyes look from two sides, so only the background is the same.
    CheckPixel(window, 0, 0, Background, "stereo");
  }
  return GetStatus();
}
