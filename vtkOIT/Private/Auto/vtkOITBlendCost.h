// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITBlendCost_h
#define vtkOITBlendCost_h

#include <cstdint>

/**
 * Whether it pays to blend the closed convex props of a frame whose order is known, each drawn
 * twice, instead of sorting their fragments in an A-buffer.
 *
 * All costs are multiples of what a fragment of unsorted blending costs, as measured on llvmpipe
 * (docs/costs.md). They decide only between two ways to the same picture.
 */
struct vtkOITBlendCost
{
  std::int64_t Props = 0;     // to be drawn twice
  std::int64_t Triangles = 0; // of them
  double Fragments = 0.0;     // of them, estimated
  std::int64_t BlendArea = 0; // pixels that they can touch
  std::int64_t FrameArea = 0; // pixels of the frame, all of which a layer covers
  std::int64_t LeftArea = 0;  // pixels of the A-buffer for all other props

  bool Pays() const
  {
    // Few props cost little either way, and many more fragments than seem to be are possible.
    if (this->Props <= FewProps)
    {
      return true;
    }
    const bool isDeep = this->Fragments > DeepLayers * static_cast<double>(this->BlendArea);
    const double saved = this->Fragments * (isDeep ? SortedDeep : Sorted) +
      SortedPixel * static_cast<double>(this->FrameArea - this->LeftArea);
    const double spent = static_cast<double>(this->Props) * SecondDraw +
      static_cast<double>(this->Triangles) * SecondTriangle +
      static_cast<double>(this->FrameArea) * LayerPixel;
    return saved >= spent;
  }

  static constexpr std::int64_t FewProps = 32;
  static constexpr double SecondDraw = 1600.0; // of a prop, without its triangles
  static constexpr double SecondTriangle = 1.0;
  static constexpr double LayerPixel = 0.85;
  static constexpr double SortedPixel = 3.0;
  static constexpr double Sorted = 1.0; // captured and sorted, beyond blending it
  static constexpr double SortedDeep = 4.0;
  /// Of one of several A-buffers of a frame: however small, and of each pixel, however few layers.
  ///@{
  static constexpr double SortedBatch = 150000.0;
  static constexpr double SortedBatchPixel = 7.0;
  ///@}
  static constexpr double BlendedIntoLayer = 1.26; // a float32 one
  static constexpr double DeepLayers = 32.0;       // that are sorted in registers
};

#endif
