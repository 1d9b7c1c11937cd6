// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Compares a picture with a baseline, in numbers that mean the same with every VTK.
 *
 * VTK's own comparison changed its metric and its thresholds between 9.3 and 9.4, so tests use
 * this one; the command line (-V baseline, -T folder for output) is VTK's.
 */

#ifndef ImageComparison_h
#define ImageComparison_h

#include "Rig/Image.h"

#include <string>

namespace vtkOITTest
{
/// How far two pictures are apart, in steps of 8 bits, over all four channels.
struct ImageDifference
{
  double Maximum = 0.0;
  double Mean = 0.0;
  int Outliers = 0; // pixels with a channel beyond ImageLimits::Maximum
};

/// VTK 9.1 on Mesa 22.3 and VTK 9.6 on Mesa 26.1 draw the baselines to the last bit. What is
/// allowed beyond that is for processors with other vector units: roundings, and a few pixels of
/// silhouettes.
struct ImageLimits
{
  double Maximum = 2.0; // of all pixels but the outliers
  double Mean = 0.02;
  int Outliers = 20;
};

/// -V and -T of the command line.
struct ImageArguments
{
  std::string Baseline;
  std::string OutputFolder = ".";

  static ImageArguments Parse(int argc, char* argv[]);
};

ImageDifference FindDifference(
  const Image& image, const Image& baseline, const ImageLimits& limits);

/// Prints the difference to the baseline; when it is beyond the limits or there is no baseline,
/// writes <name>.png and <name>.diff.png into the output folder and returns false.
bool CompareWithBaseline(
  const Image& image, const ImageArguments& arguments, const ImageLimits& limits);
}

#endif
