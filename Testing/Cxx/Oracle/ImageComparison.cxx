// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Oracle/ImageComparison.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace vtkOITTest
{
namespace
{
double GetByte(float value)
{
  return std::round(255.0 * value);
}

void Write(const Image& image, const std::string& path)
{
  vtkNew<vtkImageData> data;
  data->SetDimensions(image.Width, image.Height, 1);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* bytes = static_cast<unsigned char*>(data->GetScalarPointer());
  for (const glm::vec4& pixel : image.Pixels)
  {
    for (int channel = 0; channel < 4; ++channel)
    {
      *bytes++ = static_cast<unsigned char>(GetByte(pixel[channel]));
    }
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(data);
  writer->Write();
  std::printf("wrote %s\n", path.c_str());
}

Image Read(const std::string& path)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkImageData* data = reader->GetOutput();
  int size[3];
  data->GetDimensions(size);
  const int components = data->GetNumberOfScalarComponents();
  Image image{ size[0], size[1], {} };
  const auto* bytes = static_cast<const unsigned char*>(data->GetScalarPointer());
  for (int i = 0; i < size[0] * size[1]; ++i)
  {
    glm::vec4 pixel(1.0f);
    for (int channel = 0; channel < std::min(components, 4); ++channel)
    {
      pixel[channel] = bytes[i * components + channel] / 255.0f;
    }
    image.Pixels.push_back(pixel);
  }
  return image;
}

/// The differences, eight times larger, opaque.
Image Visualize(const Image& image, const Image& baseline)
{
  Image difference{ image.Width, image.Height, {} };
  for (std::size_t i = 0; i < image.Pixels.size(); ++i)
  {
    glm::vec4 pixel(1.0f);
    const float alpha = std::abs(image.Pixels[i].a - baseline.Pixels[i].a);
    for (int channel = 0; channel < 3; ++channel)
    {
      const float value = std::abs(image.Pixels[i][channel] - baseline.Pixels[i][channel]);
      pixel[channel] = std::min(1.0f, 8.0f * std::max(value, alpha));
    }
    difference.Pixels.push_back(pixel);
  }
  return difference;
}
}

//------------------------------------------------------------------------------
ImageArguments ImageArguments::Parse(int argc, char* argv[])
{
  ImageArguments arguments;
  for (int i = 1; i + 1 < argc; ++i)
  {
    const std::string option = argv[i];
    if (option == "-V")
    {
      arguments.Baseline = argv[i + 1];
    }
    else if (option == "-T")
    {
      arguments.OutputFolder = argv[i + 1];
    }
  }
  return arguments;
}

//------------------------------------------------------------------------------
ImageDifference FindDifference(const Image& image, const Image& baseline, const ImageLimits& limits)
{
  ImageDifference difference;
  for (std::size_t i = 0; i < image.Pixels.size(); ++i)
  {
    double largest = 0.0;
    for (int channel = 0; channel < 4; ++channel)
    {
      const double value =
        std::abs(GetByte(image.Pixels[i][channel]) - GetByte(baseline.Pixels[i][channel]));
      largest = std::max(largest, value);
      difference.Mean += value / (4.0 * image.Pixels.size());
    }
    difference.Maximum = std::max(difference.Maximum, largest);
    difference.Outliers += largest > limits.Maximum ? 1 : 0;
  }
  return difference;
}

//------------------------------------------------------------------------------
bool CompareWithBaseline(
  const Image& image, const ImageArguments& arguments, const ImageLimits& limits)
{
  const std::string name = vtksys::SystemTools::GetFilenameWithoutLastExtension(arguments.Baseline);
  const std::string path = arguments.OutputFolder + "/" + (name.empty() ? "picture" : name);
  vtksys::SystemTools::MakeDirectory(arguments.OutputFolder);
  if (arguments.Baseline.empty() || !vtksys::SystemTools::FileExists(arguments.Baseline, true))
  {
    std::printf("FAILED: there is no baseline '%s'\n", arguments.Baseline.c_str());
    Write(image, path + ".png");
    return false;
  }
  const Image baseline = Read(arguments.Baseline);
  if (image.Width != baseline.Width || image.Height != baseline.Height || image.Pixels.empty())
  {
    std::printf("FAILED: the picture has %d x %d pixels, the baseline %d x %d\n", image.Width,
      image.Height, baseline.Width, baseline.Height);
    Write(image, path + ".png");
    return false;
  }
  const ImageDifference difference = FindDifference(image, baseline, limits);
  const bool same = difference.Mean <= limits.Mean && difference.Outliers <= limits.Outliers;
  std::printf("%s: difference to the baseline, in steps of 8 bits: max %.0f, mean %.4f (allowed "
              "%.4f), %d pixels beyond %.0f (allowed %d)\n",
    same ? "passed" : "FAILED", difference.Maximum, difference.Mean, limits.Mean,
    difference.Outliers, limits.Maximum, limits.Outliers);
  if (!same)
  {
    Write(image, path + ".png");
    Write(Visualize(image, baseline), path + ".diff.png");
  }
  return same;
}
}
