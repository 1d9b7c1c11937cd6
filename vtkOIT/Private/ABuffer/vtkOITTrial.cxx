// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/ABuffer/vtkOITTrial.h"

#include <algorithm>
#include <cstdlib>

namespace
{
constexpr int FirstPause = 4;
constexpr int LongestPause = 64;
constexpr int LongestUse = 256; // frames until it has to prove itself again

// VTK's mappers look up their shaders again when a prop is drawn in another pass, twice a frame:
// 1.5 ms for each, as much as storing and sorting 14000 fragments takes on llvmpipe.
constexpr std::int64_t FragmentsPerProp = 20000;
}

//------------------------------------------------------------------------------
bool vtkOITTrial::Choose(std::int64_t props)
{
  if (props != this->Props)
  {
    this->Reset(); // another scene
    this->Props = props;
  }
  const bool canTry = this->Without >= FragmentsPerProp * props && this->Wait == 0;
  this->Wait = std::max(0, this->Wait - 1);
  this->IsOn = props > 0 && (this->HasPaid || canTry);
  return this->IsOn;
}

//------------------------------------------------------------------------------
// With half of the fragments saved, 17 layers deep, it cost as much as it saved on llvmpipe.
bool vtkOITTrial::Pays(std::int64_t saved) const
{
  return 5 * saved >= 3 * this->Without && saved >= FragmentsPerProp * this->Props;
}

//------------------------------------------------------------------------------
void vtkOITTrial::Note(std::int64_t fragments)
{
  if (!this->IsOn)
  {
    this->Without = fragments;
    return;
  }
  if (!this->HasPaid)
  {
    this->With = fragments;
    this->HasPaid = this->Pays(this->Without - fragments);
    this->Pause = this->HasPaid ? FirstPause : std::min(2 * this->Pause, LongestPause);
    this->Wait = this->HasPaid ? LongestUse : this->Pause;
  }
  else if (this->Wait == 0 || std::abs(fragments - this->With) > this->With / 4)
  {
    this->HasPaid = false;
    this->Without = -1;
    this->Wait = 0;
  }
}
