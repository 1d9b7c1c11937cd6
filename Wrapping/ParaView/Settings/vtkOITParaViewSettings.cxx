// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITParaViewSettings.h"

#include "vtkOITProcessHook.h"
#include "vtkObjectFactory.h"
#include "vtkPVView.h"
#include "vtkRenderWindow.h"

#include <cstdlib>
#include <cstring>

namespace
{
// In the order of the page's list.
constexpr const char* Names[] = { "", "auto", "abuffer", "peel", "dual", "multilayer", "bucket",
  "bucket-pairs", "bucket-adaptive" };
constexpr int NumberOfNames = sizeof(Names) / sizeof(Names[0]);
}

//------------------------------------------------------------------------------
vtkOITParaViewSettings* vtkOITParaViewSettings::GetInstance()
{
  // Never destroyed: proxies of ParaView may come to an end after our static objects.
  static vtkOITParaViewSettings* instance = []
  {
    auto* made = new vtkOITParaViewSettings;
    made->InitializeObjectBase();
    return made;
  }();
  return instance;
}

//------------------------------------------------------------------------------
vtkOITParaViewSettings* vtkOITParaViewSettings::New()
{
  vtkOITParaViewSettings* instance = vtkOITParaViewSettings::GetInstance();
  instance->Register(nullptr);
  return instance;
}

//------------------------------------------------------------------------------
const char* vtkOITParaViewSettings::GetMethodName(int method)
{
  return method >= 0 && method < NumberOfNames ? Names[method] : nullptr;
}

//------------------------------------------------------------------------------
void vtkOITParaViewSettings::Start()
{
  const char* log = std::getenv("VTKOIT_LOG");
  vtkOITProcessHook::SetLog(log && !std::strcmp(log, "1"));
  vtkOITProcessHook::SetRespectDepthPeeling(true);
  vtkOITProcessHook::SetWatch(true); // with the page at Off, too
  if (this->Method != 0)
  {
    vtkOITProcessHook::Install(Names[this->Method]);
  }
}

//------------------------------------------------------------------------------
void vtkOITParaViewSettings::SetMethod(int method)
{
  if (!vtkOITParaViewSettings::GetMethodName(method))
  {
    vtkErrorMacro("Method " << method << " is refused; give 0 (off) to " << NumberOfNames - 1);
    return;
  }
  if (this->Method == method)
  {
    return;
  }
  this->Method = method;
  if (method == 0)
  {
    vtkOITProcessHook::Uninstall();
  }
  else
  {
    vtkOITProcessHook::Install(Names[method]);
  }
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkOITParaViewSettings::SetBufferLimit(int mebibytes)
{
  if (this->BufferLimit != mebibytes &&
    vtkOITProcessHook::SetMaximumBufferSize(static_cast<vtkTypeInt64>(mebibytes) * (1 << 20)))
  {
    this->BufferLimit = mebibytes;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkOITParaViewSettings::SetTransmittanceThreshold(double threshold)
{
  if (this->TransmittanceThreshold != threshold &&
    vtkOITProcessHook::SetTransmittanceThreshold(threshold))
  {
    this->TransmittanceThreshold = threshold;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkOITParaViewSettings::ReachView(vtkObject* view)
{
  if (auto* pvView = vtkPVView::SafeDownCast(view))
  {
    vtkOITProcessHook::ReachWindow(pvView->GetRenderWindow());
  }
}

//------------------------------------------------------------------------------
void vtkOITParaViewSettings::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << '\n'
     << indent << "BufferLimit: " << this->BufferLimit << '\n'
     << indent << "TransmittanceThreshold: " << this->TransmittanceThreshold << '\n';
}
