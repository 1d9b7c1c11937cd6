// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Peeling/vtkOITPropCulling.h"

//------------------------------------------------------------------------------
void vtkOITPropCulling::Begin(vtkOpenGLRenderWindow* window, const std::vector<vtkProp*>& props)
{
  this->Queries.StartRow(window);
  this->Entries.clear();
  this->Index.clear();
  for (vtkProp* prop : props)
  {
    const auto added = this->Index.emplace(prop, this->Entries.size());
    if (!added.second)
    {
      this->Entries[added.first->second].IsUnknown = true; // listed twice
    }
    Entry entry;
    entry.Prop = prop;
    entry.IsUnknown = !added.second;
    this->Entries.push_back(entry);
  }
  this->Slot = 0;
}

//------------------------------------------------------------------------------
void vtkOITPropCulling::ReadResults(std::size_t slot)
{
  for (std::size_t i = 0; i < this->Entries.size(); ++i)
  {
    Entry& entry = this->Entries[i];
    const std::size_t number = this->GetNumber(i, slot);
    if (entry.IsAsked[slot] && !entry.IsUnknown && this->Queries.IsAvailable(number))
    {
      entry.IsDone = entry.IsDone || this->Queries.GetResult(number) == 0;
    }
  }
}

//------------------------------------------------------------------------------
std::vector<vtkProp*> vtkOITPropCulling::BeginPass()
{
  this->Slot = 1 - this->Slot;
  this->ReadResults(this->Slot); // of the pass before last; its queries are used anew
  std::vector<vtkProp*> left;
  for (Entry& entry : this->Entries)
  {
    entry.IsAsked[this->Slot] = false;
    if (!entry.IsDone)
    {
      left.push_back(entry.Prop);
    }
  }
  this->Current = None;
  return left;
}

//------------------------------------------------------------------------------
void vtkOITPropCulling::Draw(vtkProp* prop)
{
  const auto found = this->Index.find(prop);
  const std::size_t next = found == this->Index.end() ? None : found->second;
  if (next == this->Current)
  {
    return;
  }
  this->EndPass();
  if (next == None)
  {
    return; // a part of an assembly: it is not known which prop it belongs to
  }
  Entry& entry = this->Entries[next];
  entry.IsUnknown = entry.IsUnknown || entry.IsAsked[this->Slot];
  if (!entry.IsUnknown)
  {
    entry.IsAsked[this->Slot] = true;
    this->Current = next;
    this->Queries.Begin(this->GetNumber(next, this->Slot));
  }
}

//------------------------------------------------------------------------------
void vtkOITPropCulling::EndPass()
{
  if (this->Current != None)
  {
    this->Queries.End();
    this->Current = None;
  }
}
