// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITPassFactory.h"

#include "vtkOITABufferPass.h"
#include "vtkOITAutoPass.h"
#include "vtkOITBucketPeelingPass.h"
#include "vtkOITDeferredPeelingPass.h"
#include "vtkOITDepthPeelingPass.h"
#include "vtkOITDualDepthPeelingPass.h"
#include "vtkOITMultiLayerPeelingPass.h"
#include "vtkOITWeightedPass.h"
#include "vtkObjectFactory.h"

#include <array>

namespace
{
struct Method
{
  const char* Name;
  vtkOITPass* (*Create)();
};

template <typename PassType>
vtkOITPass* CreateAs()
{
  return PassType::New();
}

template <typename PassType, int Mode>
vtkOITPass* CreateInMode()
{
  PassType* pass = PassType::New();
  pass->SetMode(Mode);
  return pass;
}

const std::array<Method, 13> Methods = { {
  { "auto", CreateAs<vtkOITAutoPass> },
  { "abuffer", CreateAs<vtkOITABufferPass> },
  { "deferred-abuffer",
    CreateInMode<vtkOITDeferredPeelingPass, vtkOITDeferredPeelingPass::A_BUFFER> },
  { "deferred", CreateInMode<vtkOITDeferredPeelingPass, vtkOITDeferredPeelingPass::PEELING> },
  { "peel", CreateAs<vtkOITDepthPeelingPass> },
  { "dual", CreateAs<vtkOITDualDepthPeelingPass> },
  { "multilayer", CreateAs<vtkOITMultiLayerPeelingPass> },
  { "bucket", CreateInMode<vtkOITBucketPeelingPass, vtkOITBucketPeelingPass::UNIFORM> },
  { "bucket-pairs", CreateInMode<vtkOITBucketPeelingPass, vtkOITBucketPeelingPass::PAIRS> },
  { "bucket-adaptive", CreateInMode<vtkOITBucketPeelingPass, vtkOITBucketPeelingPass::ADAPTIVE> },
  { "weighted-average", CreateInMode<vtkOITWeightedPass, vtkOITWeightedPass::AVERAGE> },
  { "weighted-sum", CreateInMode<vtkOITWeightedPass, vtkOITWeightedPass::SUM> },
  { "weighted-blended", CreateInMode<vtkOITWeightedPass, vtkOITWeightedPass::BLENDED> },
} };
}

vtkStandardNewMacro(vtkOITPassFactory);

//------------------------------------------------------------------------------
int vtkOITPassFactory::GetNumberOfMethods()
{
  return static_cast<int>(Methods.size());
}

//------------------------------------------------------------------------------
std::string vtkOITPassFactory::GetMethodName(int index)
{
  return index >= 0 && index < GetNumberOfMethods() ? Methods[index].Name : std::string();
}

//------------------------------------------------------------------------------
vtkOITPass* vtkOITPassFactory::CreatePass(const std::string& methodName)
{
  for (const Method& method : Methods)
  {
    if (methodName == method.Name)
    {
      return method.Create();
    }
  }
  return nullptr;
}
