//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Divide, of an adaptive single shot: a slot for each depth that a bucket has told, in order, and
// slots between the two of a bucket for its other fragments: as many as there are, and more where room
// is left, at least one each. The table of a pixel:
//
//   0, 1, 2  of 12 buckets: 64 times the first slot, plus the number of slots between
//   3        words of a slot; slots; fragments; optical depth of all

uniform sampler2DArray oitShot;

layout(location = 0) out vec4 oitTable0;
layout(location = 1) out vec4 oitTable1;
layout(location = 2) out vec4 oitTable2;
layout(location = 3) out vec4 oitTable3;

void main()
{
  float fragments = texelFetch(oitShot, ivec3(gl_FragCoord.xy, 6), 0).a;
  if (fragments == 0.0)
  {
    discard; // nobody asks
  }
  float channels[24];
  float counts[12];
  vec4 buffer;
  for (int i = 0; i < 8; ++i)
  {
    buffer = texelFetch(oitShot, ivec3(gl_FragCoord.xy, i), 0);
    channels[3 * i] = buffer.r;
    channels[3 * i + 1] = buffer.g;
    channels[3 * i + 2] = buffer.b;
    if (i < 6)
    {
      counts[2 * i + 1] = floor(buffer.a / float(OIT_COUNT_BASE));
      counts[2 * i] = buffer.a - counts[2 * i + 1] * float(OIT_COUNT_BASE);
    }
  }

  int known = 0;   // depths
  int between = 0; // fragments, where there are several in a bucket
  int single = 0;  // buckets with one fragment between
  for (int i = 0; i < 12; ++i)
  {
    bool isPair = channels[2 * i + 1] > -channels[2 * i];
    int rest = isPair ? int(counts[i]) - 2 : 0;
    known += counts[i] < 0.5 ? 0 : isPair ? 2 : 1;
    single += rest == 1 ? 1 : 0;
    between += rest > 1 ? rest : 0;
  }
  int least = known + single;
  // What may lie close together gets all the room that colours of 15 bits leave, or else those of 8: a
  // coarser colour is off by less than one that is lost.
  int room = 16 - least < 5 * between ? 32 : 16;
  room = (between == 0 && least <= 8 ? 8 : room) - least;
  float share = between > 0 ? float(max(room, 0)) / float(between) : 0.0;

  float entries[12];
  int slots = 0;
  for (int i = 0; i < 12; ++i)
  {
    bool isPair = channels[2 * i + 1] > -channels[2 * i];
    int rest = isPair ? int(counts[i]) - 2 : 0;
    // Not less than one, if there is one: the others have to make room.
    int mine = rest <= 1 ? rest : max(int(float(rest) * share), 1);
    mine = min(mine, max(31 - slots, 0));
    entries[i] = float(64 * slots + mine);
    slots += counts[i] < 0.5 ? 0 : isPair ? 2 + mine : 1;
  }
  float words = slots <= 8 ? 4.0 : slots <= 16 ? 2.0 : 1.0;
  oitTable0 = vec4(entries[0], entries[1], entries[2], entries[3]);
  oitTable1 = vec4(entries[4], entries[5], entries[6], entries[7]);
  oitTable2 = vec4(entries[8], entries[9], entries[10], entries[11]);
  oitTable3 = vec4(words, float(slots), fragments, buffer.a);
}
