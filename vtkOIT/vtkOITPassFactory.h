// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOITPassFactory
 * @brief   creates passes by the method names of Python and the command line
 *
 * The one list of method names (`auto`, `abuffer`, ...) and of the passes that they stand for.
 *
 * @sa vtkOITPass vtkOITRendererHook
 */

#ifndef vtkOITPassFactory_h
#define vtkOITPassFactory_h

#include "vtkOITModule.h" // for the export macro
#include "vtkObject.h"

#include <string> // for the names

class vtkOITPass;

class VTKOIT_EXPORT vtkOITPassFactory : public vtkObject
{
public:
  static vtkOITPassFactory* New();
  vtkTypeMacro(vtkOITPassFactory, vtkObject);

  /// The number of methods and the name of each, index in [0, GetNumberOfMethods()); an empty
  /// string for an index outside it.
  ///@{
  static int GetNumberOfMethods();
  static std::string GetMethodName(int index);
  ///@}

  /// A new pass for a method's name, owned by the caller, or nullptr for an unknown name.
  VTK_NEWINSTANCE static vtkOITPass* CreatePass(const std::string& methodName);

protected:
  vtkOITPassFactory() = default;
  ~vtkOITPassFactory() override = default;

private:
  vtkOITPassFactory(const vtkOITPassFactory&) = delete;
  void operator=(const vtkOITPassFactory&) = delete;
};

#endif
