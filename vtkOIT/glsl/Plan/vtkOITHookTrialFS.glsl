// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Trial: leaves out all fragments of a prop, so that an occlusion query counts only those that do
// not come here.

void main()
{
  oitShade();
  discard;
}
