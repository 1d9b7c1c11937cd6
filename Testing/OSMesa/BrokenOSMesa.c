/*
 * SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Stands in for libOSMesa in TestBrokenLibrary: it makes CONTEXTS contexts, which nobody may draw
 * with, and then none. Without CONTEXTS it has no function at all.
 */
#ifdef CONTEXTS
static int left = CONTEXTS;
static int context;

void* OSMesaCreateContextAttribs(const int* attributes, void* share)
{
  (void)attributes;
  (void)share;
  return left-- > 0 ? &context : 0;
}

void OSMesaDestroyContext(void* which)
{
  (void)which;
}

unsigned char OSMesaMakeCurrent(void* which, void* buffer, unsigned type, int width, int height)
{
  (void)which;
  (void)buffer;
  (void)type;
  (void)width;
  (void)height;
  return 0;
}

void* OSMesaGetCurrentContext(void)
{
  return 0;
}

unsigned char OSMesaGetColorBuffer(void* which, int* width, int* height, int* format, void** buffer)
{
  (void)which;
  *width = *height = *format = 0;
  *buffer = 0;
  return 0;
}

void* OSMesaGetProcAddress(const char* name)
{
  (void)name;
  return 0;
}
#else
extern int vtkOITBrokenOSMesa;
int vtkOITBrokenOSMesa = 0;
#endif
