// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITTrial_h
#define vtkOITTrial_h

#include <cstdint>

/**
 * Finds by trial whether it pays to leave out hidden fragments, which costs a geometry pass.
 *
 * The fragments of a frame without it and of the next one with it tell what it saves. When it pays
 * it stays on until the number of fragments changes much, or for 256 frames; then it is tried anew.
 * Otherwise it is tried again after a pause, of up to 64 frames.
 */
class vtkOITTrial
{
public:
  /// Whether to do so in this frame, where so many props have to be drawn for it.
  bool Choose(std::int64_t props);

  /// The fragments of this frame.
  void Note(std::int64_t fragments);

  /// Starts from nothing known.
  void Reset() { *this = {}; }

private:
  bool Pays(std::int64_t saved) const;

  std::int64_t Props = 0;
  std::int64_t Without = -1; // fragments of the last frame without it; negative when not known
  std::int64_t With = -1;    // fragments of the trial
  bool IsOn = false;         // in this frame
  bool HasPaid = false;      // in the last trial
  int Wait = 0;              // frames until the next trial
  int Pause = 4;             // frames before that
};

#endif
