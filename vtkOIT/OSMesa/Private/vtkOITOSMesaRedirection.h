// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Points the OpenGL calls of VTK and of what uses VTK at OSMesa.
 *
 * A VTK that was built for X has its calls bound to libGL, or to whatever OpenGL library the
 * process loaded first, and its GLEW insists on GLX. The order in which libraries are linked or
 * loaded is not in our hands (in Python VTK may have been imported long ago), so the calls are
 * redirected where ELF keeps them: in the tables through which an object reaches functions of
 * other objects. Every object that VTK's libraries or GLEW belong to or that needs one of them is
 * treated; all others, Qt for example, keep their OpenGL. Three GLX functions, which is all that
 * GLEW calls, are answered by stand-ins that need no X server.
 */

#ifndef vtkOITOSMesaRedirection_h
#define vtkOITOSMesaRedirection_h

#include <string>

namespace vtkOITOSMesaRedirection
{
/**
 * Treats the objects that were loaded since the last call; cheap when there is none. Returns an
 * empty string or one line that says what went wrong. libOSMesa must be usable.
 */
std::string Update();
}

#endif
