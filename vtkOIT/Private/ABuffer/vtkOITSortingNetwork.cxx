// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/ABuffer/vtkOITSortingNetwork.h"

#include <sstream>

namespace
{
/// Batcher's odd-even merge sort, as compare-exchanges of registers. For sizes that are no power of
/// two it is the network of the next one without the exchanges beyond the size, where nothing that
/// sorts before could be.
void WriteSortingNetwork(std::ostream& os, int size)
{
  for (int p = 1; p < size; p *= 2)
  {
    for (int k = p; k >= 1; k /= 2)
    {
      for (int j = k % p; j + k < size; j += 2 * k)
      {
        for (int i = j; i < j + k && i + k < size; ++i)
        {
          if (i / (2 * p) == (i + k) / (2 * p))
          {
            os << "OIT_COMPARE_EXCHANGE(" << i << ", " << i + k << ")\n";
          }
        }
      }
    }
  }
}

/// The macro for each of the registers from `first` up to `end`.
void WriteForEach(std::ostream& os, const char* macro, int first, int end)
{
  for (int i = first; i < end; ++i)
  {
    os << macro << "(" << i << ")\n";
  }
}

/// The macro for each of the registers and the one behind it.
void WriteForPairs(std::ostream& os, const char* macro, int size)
{
  for (int i = 0; i < size; ++i)
  {
    os << macro << "(" << i << ", " << i + 1 << ")\n";
  }
}

void WriteTies(std::ostream& os, int size)
{
  for (int i = 0; i + 1 < size; ++i)
  {
    os << "OIT_NOTE_TIE(" << i << ", " << i + 1 << ")\n";
  }
}
}

//------------------------------------------------------------------------------
std::string vtkOITRegisterResolve(int size)
{
  std::ostringstream os;
  WriteForEach(os, "OIT_DECLARE", 0, size);
  WriteForEach(os, "OIT_LOAD", 0, size);
  WriteSortingNetwork(os, size);
  WriteTies(os, size);
  WriteForEach(os, "OIT_BLEND", 0, size);
  return os.str();
}

//------------------------------------------------------------------------------
std::string vtkOITRegisterSelect(int size, int kept)
{
  std::ostringstream os;
  WriteForEach(os, "OIT_DECLARE", 0, size);
  os << "do\n{\nif (count == 0u)\n{\n";
  WriteForEach(os, "OIT_LOAD", 0, kept);
  os << "}\n";
  WriteForEach(os, "OIT_LOAD", kept, size);
  WriteSortingNetwork(os, size);
  os << "thin = 1.0;\n";
  WriteForEach(os, "OIT_THIN", 0, kept - 1);
  os << "} while (node != OIT_END && (count < " << size << "u || thin <= oitThreshold));\n"
     << "isLong = count > " << size << "u;\n";
  WriteForEach(os, "OIT_FORGET", kept, size);
  WriteTies(os, size);
  WriteForEach(os, "OIT_BLEND", 0, size);
  return os.str();
}

//------------------------------------------------------------------------------
// The farthest one kept waits for the next walk, as it might coincide with one that was not.
std::string vtkOITRegisterWalk(int kept, int most)
{
  std::ostringstream os;
  WriteForEach(os, "OIT_DECLARE", 0, kept);
  os << "uint last = 0u;\nuint done = 0u;\nbool isMore = head != OIT_END;\n"
     << "for (int walk = 0; walk < " << (most - 2) / (kept - 1) + 1 << " && isMore; ++walk)\n{\n";
  WriteForEach(os, "OIT_RESET", 0, kept);
  os << "count = 0u;\nfor (node = head; node != OIT_END; ++count)\n{\n"
     << "OITFragment f = oitRead(node);\nnode = f.Next;\n"
     << "uint key = done > 0u && f.Key <= last ? OIT_NO_KEY : f.Key;\nOITColor fresh = f.Color;\n";
  WriteForEach(os, "OIT_INSERT", 0, kept);
  os << "}\nisMore = count - done > " << kept << "u;\n";
  WriteTies(os, kept);
  WriteForEach(os, "OIT_BLEND", 0, kept - 1);
  os << "color" << kept - 1 << " = isMore ? OITColor(0u) : color" << kept - 1 << ";\n";
  WriteForEach(os, "OIT_BLEND", kept - 1, kept);
  os << "last = key" << kept - 2 << ";\ndone += " << kept - 1 << "u;\n"
     << "isLong = OIT_IS_AT_END;\n"
     << "isMore = isMore && !isTied && !isLong && transmittance > 0.0;\n}\n"
     << "thin = transmittance;\nisTied = isTied || isMore;\n";
  return os.str();
}

//------------------------------------------------------------------------------
vtkOITRegisterMerge::vtkOITRegisterMerge(int size, int runs)
{
  std::ostringstream declare;
  WriteForEach(declare, "OIT_DECLARE_RUN", 0, runs);
  declare << "const uint start" << runs << " = OIT_END;\n";
  this->Declare = declare.str();
  std::ostringstream run;
  WriteForEach(run, "OIT_START_RUN", 0, runs);
  WriteForEach(run, "OIT_LOAD", 0, size);
  run << "uint node" << size << " = node;\n";
  WriteSortingNetwork(run, size);
  WriteForPairs(run, "OIT_REWRITE", size);
  this->Run = run.str();
  std::ostringstream load;
  WriteForEach(load, "OIT_CHOOSE", 0, runs);
  load << "OITFragment loaded = OIT_NO_FRAGMENT;\n"
       << "if (at != OIT_END)\n{\nloaded = oitRead(at);\n}\n";
  WriteForPairs(load, "OIT_TAKE", runs);
  this->Load = load.str();
  std::ostringstream compare;
  WriteForEach(compare, "OIT_COMPARE", 0, runs);
  this->Compare = compare.str();
}

//------------------------------------------------------------------------------
std::string vtkOITRegisterSort(int size)
{
  std::ostringstream os;
  WriteForEach(os, "OIT_LOAD", 0, size);
  WriteSortingNetwork(os, size);
  os << "OITFragment last = f0;\n";
  WriteForEach(os, "OIT_LINK", 0, size);
  return os.str();
}
