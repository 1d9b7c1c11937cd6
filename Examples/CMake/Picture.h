// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Picture_h
#define Picture_h

#include <string>

/// Draws a glass cone over a glass plate into a PNG file; false, with a message, when it cannot.
bool WritePicture(const std::string& fileName);

#endif
