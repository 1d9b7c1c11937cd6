//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// One triangle with the corners (-1, -1), (3, -1), (-1, 3): it covers the viewport without the
// diagonal that two triangles would have, where pixels are shaded twice in part.

void main()
{
  gl_Position = vec4(4.0 * float(gl_VertexID & 1) - 1.0, 4.0 * float(gl_VertexID >> 1) - 1.0, 0.0, 1.0);
}
