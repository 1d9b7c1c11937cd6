// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the tests of vtkOITOSMesa share: checks that count, a scene whose colours are known exactly,
 * and a catcher for VTK's error messages.
 */

#ifndef HeadlessTest_h
#define HeadlessTest_h

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkOITHeadless.h"
#include "vtkOutputWindow.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkStringOutputWindow.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <iostream>
#include <string>

namespace HeadlessTest
{
/// VTK's code for a test that could not run.
constexpr int Skipped = 125;

inline int Failures = 0;

inline void Check(bool condition, const std::string& what)
{
  if (!condition)
  {
    std::cerr << "FAILED: " << what << std::endl;
    ++Failures;
  }
}

/// The exit status of a test.
inline int GetStatus()
{
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

/// True when the windows are this module's own.
inline bool HasOwnWindow()
{
  vtkNew<vtkRenderWindow> window;
  return window->IsA("vtkOITOSMesaRenderWindow");
}

using Colour = std::array<unsigned char, 3>;

inline std::string ToString(const Colour& colour)
{
  return std::to_string(colour[0]) + " " + std::to_string(colour[1]) + " " +
    std::to_string(colour[2]);
}

/// A renderer that shows a quad of one colour, half as wide and high as the window, in the middle.
inline vtkSmartPointer<vtkRenderer> MakeScene(const Colour& quad, const Colour& background)
{
  vtkNew<vtkPlaneSource> plane;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(quad[0] / 255., quad[1] / 255., quad[2] / 255.);
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->AddActor(actor);
  renderer->SetBackground(background[0] / 255., background[1] / 255., background[2] / 255.);
  return renderer;
}

/// The colour of one pixel; front is what the last finished frame shows.
inline Colour GetPixel(vtkRenderWindow* window, int x, int y, int front = 1)
{
  vtkNew<vtkUnsignedCharArray> pixel;
  if (window->GetPixelData(x, y, x, y, front, pixel) != VTK_OK || pixel->GetNumberOfValues() < 3)
  {
    return { 1, 2, 3 };
  }
  return { pixel->GetValue(0), pixel->GetValue(1), pixel->GetValue(2) };
}

inline void CheckPixel(
  vtkRenderWindow* window, int x, int y, const Colour& expected, const std::string& what)
{
  const Colour found = GetPixel(window, x, y);
  Check(found == expected,
    what + ": pixel " + std::to_string(x) + " " + std::to_string(y) + " is " + ToString(found) +
      ", expected " + ToString(expected));
}

/// The middle shows the quad and every corner the background.
inline void CheckScene(
  vtkRenderWindow* window, const Colour& quad, const Colour& background, const std::string& what)
{
  const int* size = window->GetSize();
  CheckPixel(window, size[0] / 2, size[1] / 2, quad, what + ", middle");
  if (size[0] < 16 || size[1] < 16)
  {
    return;
  }
  for (const int x : { 0, size[0] - 1 })
  {
    for (const int y : { 0, size[1] - 1 })
    {
      CheckPixel(window, x, y, background, what + ", corner");
    }
  }
}

/// Catches what VTK reports while it exists.
class Messages
{
public:
  Messages()
    : Before(vtkOutputWindow::GetInstance())
  {
    vtkOutputWindow::SetInstance(this->Catcher);
  }
  ~Messages() { vtkOutputWindow::SetInstance(this->Before); }

  std::string Get() { return this->Catcher->GetOutput(); }

  /// The number of error messages.
  int Count()
  {
    const std::string text = this->Get();
    int count = 0;
    for (size_t at = text.find("ERROR:"); at != std::string::npos; at = text.find("ERROR:", at + 1))
    {
      ++count;
    }
    return count;
  }

private:
  Messages(const Messages&) = delete;
  void operator=(const Messages&) = delete;

  vtkNew<vtkStringOutputWindow> Catcher;
  vtkSmartPointer<vtkOutputWindow> Before;
};
}

#endif
