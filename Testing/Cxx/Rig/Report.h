// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Counts what a test checks and says each result in numbers.
 */

#ifndef Report_h
#define Report_h

#include "Rig/Image.h"
#include "Rig/Layer.h"

#include <functional>
#include <string>
#include <vector>

namespace vtkOITTest
{
class Report
{
public:
  /// The RGBA that is right for a pixel.
  using Expected = std::function<glm::dvec4(int x, int y)>;

  /// Prefix of every line, for example the method and the way it is used.
  void SetContext(const std::string& context) { this->Context = context; }

  /// The number in docs/stress-tests.md that the next comparisons belong to; 0 for none.
  void SetStressTest(int number) { this->StressTest = number; }

  /// From now on nothing fails. Comparisons, with their tolerances widened by this, are kept as
  /// results; conditions are not looked at. Pictures of at most 512 pixels in either direction are
  /// written into the folder, when one is named: NUMBER-is.ppm and NUMBER-should.ppm.
  void Observe(const Tolerance& added, const std::string& pictures = {});

  /// A comparison of an observing report.
  struct Result
  {
    int StressTest = 0;
    std::string What;
    Tolerance Error;     // the largest differences, infinite where a number is not finite
    Tolerance Allowed;   // what was added included
    std::string Picture; // the files' name without -is.ppm; empty for none
  };
  const std::vector<Result>& GetResults() const { return this->Results; }

  /// Records a condition; prints the message only when it does not hold.
  bool Check(bool condition, const std::string& message);

  /// Every pixel within the tolerance of its expected value, colour and alpha; prints the largest
  /// and the mean differences.
  bool Compare(const std::string& what, const Image& image, const Expected& expected,
    const Tolerance& tolerance);
  bool Compare(
    const std::string& what, const Image& image, const Image& expected, const Tolerance& tolerance);

  /// Every pixel has the same bits; when observing, just no difference beyond what is added.
  bool CompareBits(const std::string& what, const Image& image, const Image& expected);

  /// 0 when at least one thing was checked and all of it held; when observing, the former.
  int GetExitStatus() const;

private:
  /// Writes the pictures of an observed comparison; the name of the files, empty for none.
  std::string KeepPictures(const Image& image, const Expected& expected) const;

  std::string Context;
  int NumberOfChecks = 0;
  int NumberOfFailures = 0;
  int StressTest = 0;
  bool IsObserving = false;
  Tolerance Added;
  std::string Pictures;
  std::vector<Result> Results;
};
}

#endif
