// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITBands_h
#define vtkOITBands_h

#include "Private/Frame/vtkOITFailure.h"
#include "Private/Frame/vtkOITRectangle.h"

#include <cstdint>
#include <functional>
#include <vector>

/**
 * Divides a rectangle into parts that fit into limited memory, and remembers the division for the
 * next frame. Normally there is one part, the whole rectangle.
 */
class vtkOITBands
{
public:
  /// Starts a frame: the division of the last frame where it still applies; no part is larger
  /// than `largestArea` pixels.
  void Begin(const vtkOITRectangle& rectangle, std::int64_t largestArea);

  /// The next part to render. False at the end of the frame.
  bool GetNext(vtkOITRectangle& band);

  /// The part given last did not fit: it needs `needed` of something of which there is `capacity`.
  /// It is divided into at least two parts that should fit, and they come next. False when it is a
  /// single pixel.
  bool Split(std::int64_t needed, std::int64_t capacity);

  /// The part given last is done.
  void Accept() { this->Accepted.push_back(this->Current); }

  /// Draws all parts, one after the other; one for which there is no memory is divided, after `free`
  /// has freed what there is. A failure says what is not drawn.
  vtkOITFailure DrawAll(const std::function<vtkOITFailure(const vtkOITRectangle&)>& draw,
    const std::function<void()>& free);

  /// The part given last, and all after it: where nothing is drawn yet.
  std::vector<vtkOITRectangle> GetUndrawn() const;

  /// The next frame starts with one part again.
  void Forget() { this->Accepted.clear(); }

  std::size_t GetNumberOfBands() const { return this->Accepted.size(); }

private:
  void Push(const vtkOITRectangle& rectangle, std::int64_t parts);
  static int GetExtent(const vtkOITRectangle& rectangle);

  vtkOITRectangle Whole;
  vtkOITRectangle Current;
  std::int64_t LargestArea = 0;
  std::vector<vtkOITRectangle> Waiting; // the next one is the last
  std::vector<vtkOITRectangle> Accepted;
};

#endif
