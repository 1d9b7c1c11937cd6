// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Rig/Report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace vtkOITTest
{
namespace
{
constexpr int LargestPicture = 512;

/// Colours as the window shows them, rounded to 8 bits, the upper row first.
bool WritePicture(
  const std::string& fileName, int width, int height, const Report::Expected& colors)
{
  std::FILE* file = std::fopen(fileName.c_str(), "wb");
  if (!file)
  {
    return false;
  }
  std::fprintf(file, "P6 %d %d 255\n", width, height);
  for (int y = height - 1; y >= 0; --y)
  {
    for (int x = 0; x < width; ++x)
    {
      const glm::dvec4 color = colors(x, y);
      for (int channel = 0; channel < 3; ++channel)
      {
        const double value = std::isnan(color[channel]) ? 0.0 : color[channel];
        std::fputc(
          static_cast<int>(std::lround(255.0 * std::min(std::max(value, 0.0), 1.0))), file);
      }
    }
  }
  return std::fclose(file) == 0;
}
}

//------------------------------------------------------------------------------
void Report::Observe(const Tolerance& added, const std::string& pictures)
{
  this->IsObserving = true;
  this->Added = added;
  this->Pictures = pictures;
}

//------------------------------------------------------------------------------
std::string Report::KeepPictures(const Image& image, const Expected& expected) const
{
  if (this->Pictures.empty() || image.Width > LargestPicture || image.Height > LargestPicture)
  {
    return {};
  }
  const std::string name = this->Pictures + "/" + std::to_string(this->Results.size());
  const auto shown = [&image](int x, int y) { return glm::dvec4(image.At(x, y)); };
  return WritePicture(name + "-is.ppm", image.Width, image.Height, shown) &&
      WritePicture(name + "-should.ppm", image.Width, image.Height, expected)
    ? name
    : std::string();
}

//------------------------------------------------------------------------------
bool Report::Check(bool condition, const std::string& message)
{
  ++this->NumberOfChecks;
  if (!condition && !this->IsObserving)
  {
    ++this->NumberOfFailures;
    std::printf("FAILED %s: %s\n", this->Context.c_str(), message.c_str());
  }
  return condition;
}

//------------------------------------------------------------------------------
bool Report::Compare(
  const std::string& what, const Image& image, const Expected& expected, const Tolerance& stated)
{
  const Tolerance tolerance = stated + this->Added;
  double largest[2] = { 0.0, 0.0 };
  double sum[2] = { 0.0, 0.0 };
  int worstX = -1;
  int worstY = -1;
  double worstExcess = 0.0;
  std::size_t bad = 0;
  for (int y = 0; y < image.Height; ++y)
  {
    for (int x = 0; x < image.Width; ++x)
    {
      const glm::dvec4 difference = glm::dvec4(image.At(x, y)) - expected(x, y);
      double error[2] = { std::abs(difference.a), std::abs(difference.a) };
      error[0] = 0.0;
      bool finite = std::isfinite(difference.a);
      for (int channel = 0; channel < 3; ++channel)
      {
        finite = finite && std::isfinite(difference[channel]);
        error[0] = std::max(error[0], std::abs(difference[channel]));
      }
      for (int part = 0; part < 2; ++part)
      {
        error[part] = finite ? error[part] : HUGE_VAL;
        largest[part] = std::max(largest[part], error[part]);
        sum[part] += error[part];
      }
      const double excess = std::max(error[0] - tolerance.Color, error[1] - tolerance.Alpha);
      if (excess > 0.0)
      {
        ++bad;
        if (excess > worstExcess)
        {
          worstExcess = excess;
          worstX = x;
          worstY = y;
        }
      }
    }
  }
  const std::size_t count = image.Pixels.size();
  std::printf("%s %s: %s: colour max %.3g mean %.3g (allowed %.3g), alpha max %.3g mean %.3g "
              "(allowed %.3g)\n",
    this->IsObserving     ? (bad ? "differs" : "agrees")
      : bad || count == 0 ? "FAILED"
                          : "passed",
    this->Context.c_str(), what.c_str(), largest[0], sum[0] / std::max<std::size_t>(count, 1),
    tolerance.Color, largest[1], sum[1] / std::max<std::size_t>(count, 1), tolerance.Alpha);
  ++this->NumberOfChecks;
  if (this->IsObserving)
  {
    this->Results.push_back({ this->StressTest, what, { largest[0], largest[1] }, tolerance,
      this->KeepPictures(image, expected) });
    return bad == 0;
  }
  if (bad)
  {
    const glm::dvec4 is(image.At(worstX, worstY));
    const glm::dvec4 be = expected(worstX, worstY);
    std::printf("       %zu of %zu pixels; worst at (%d, %d): is %.7g %.7g %.7g %.7g, "
                "expected %.7g %.7g %.7g %.7g\n",
      bad, count, worstX, worstY, is.r, is.g, is.b, is.a, be.r, be.g, be.b, be.a);
  }
  if (bad || count == 0)
  {
    ++this->NumberOfFailures;
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool Report::Compare(
  const std::string& what, const Image& image, const Image& expected, const Tolerance& tolerance)
{
  if (!this->Check(image.Width == expected.Width && image.Height == expected.Height,
        what + ": the images have different sizes"))
  {
    return false;
  }
  return this->Compare(
    what, image, [&](int x, int y) { return glm::dvec4(expected.At(x, y)); }, tolerance);
}

//------------------------------------------------------------------------------
bool Report::CompareBits(const std::string& what, const Image& image, const Image& expected)
{
  if (!this->Check(
        !image.Pixels.empty() && image.Width == expected.Width && image.Height == expected.Height,
        what + ": the images have different sizes"))
  {
    return false;
  }
  if (this->IsObserving)
  {
    return this->Compare(what, image, expected, {});
  }
  std::size_t bad = 0;
  std::size_t worst = 0;
  for (std::size_t i = 0; i < image.Pixels.size(); ++i)
  {
    if (std::memcmp(&image.Pixels[i], &expected.Pixels[i], sizeof(glm::vec4)) != 0)
    {
      worst = bad++ == 0 ? i : worst;
    }
  }
  if (bad)
  {
    const glm::vec4& is = image.Pixels[worst];
    const glm::vec4& be = expected.Pixels[worst];
    std::printf("       %zu of %zu pixels differ; first at (%zu, %zu): is %.9g %.9g %.9g %.9g, "
                "expected %.9g %.9g %.9g %.9g\n",
      bad, image.Pixels.size(), worst % image.Width, worst / image.Width, is.r, is.g, is.b, is.a,
      be.r, be.g, be.b, be.a);
  }
  return this->Check(bad == 0, what + ": not equal bit for bit");
}

//------------------------------------------------------------------------------
int Report::GetExitStatus() const
{
  std::printf("%d checks, %d failed\n", this->NumberOfChecks, this->NumberOfFailures);
  return this->NumberOfChecks > 0 && this->NumberOfFailures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
}
