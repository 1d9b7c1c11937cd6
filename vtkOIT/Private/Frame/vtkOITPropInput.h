// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITPropInput_h
#define vtkOITPropInput_h

#include "vtkType.h"

class vtkActor;
class vtkMapper;
class vtkProp;

/**
 * What VTK tells of props and their data by bringing the pipeline up to date each time, which takes a
 * few microseconds a prop where there is nothing to update: data that were given to the mapper without
 * a pipeline (vtkAlgorithm::SetInputData()), or mappers that are static. The answers are VTK's.
 */
///@{

/// Brings the input of a mapper up to date, where there is a pipeline.
void vtkOITUpdateInput(vtkMapper* mapper);

/// As vtkProp::GetBounds(), into `bounds`; false when the prop has none.
bool vtkOITGetBounds(vtkProp* prop, double bounds[6]);

/// As vtkActor::GetRedrawMTime(), of an actor with a mapper.
vtkMTimeType vtkOITGetRedrawMTime(vtkActor* actor);

///@}

#endif
