// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITABufferPass_h
#define vtkOITABufferPass_h

#include "vtkOITModule.h" // for the export macro
#include "vtkOITPass.h"

class VTKOIT_EXPORT vtkOITABufferPass : public vtkOITPass
{
public:
  static vtkOITABufferPass* New();
  vtkTypeMacro(vtkOITABufferPass, vtkOITPass);

  const char* GetAlgorithmName() override { return "A-buffer"; }
  std::string GetMissingCapability(vtkOpenGLRenderWindow*) override { return {}; }

  enum FragmentPrecisionType
  {
    HALF = 0,
    FLOAT = 1
  };
  vtkSetClampMacro(FragmentPrecision, int, HALF, FLOAT);
  vtkGetMacro(FragmentPrecision, int);
  void SetFragmentPrecisionToHalf() { this->SetFragmentPrecision(HALF); }
  void SetFragmentPrecisionToFloat() { this->SetFragmentPrecision(FLOAT); }

protected:
  vtkOITABufferPass();
  ~vtkOITABufferPass() override;
  int FragmentPrecision = HALF;

private:
  vtkOITABufferPass(const vtkOITABufferPass&) = delete;
  void operator=(const vtkOITABufferPass&) = delete;
};

#endif
