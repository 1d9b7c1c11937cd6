//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// With OIT_DEFERRED, for lists whose fragments cannot all be lit in one draw, as software rasterizers
// limit the iterations of a shader's loops: lights some fragments of each list that is left, and keeps
// their colours in their nodes as those of fragments without lighting, which Composite takes as they are.

//VTK::OIT::Node
//VTK::OIT::Read
//VTK::OIT::Light

uniform int oitFirstFragment; // of a list
uniform int oitLastFragment;

void main()
{
  uint node = imageLoad(oitHeads, ivec2(gl_FragCoord.xy) - oitOrigin).x;
  bool isMine = (node & OIT_LEFT) != 0u;
  node = isMine ? node & ~OIT_LEFT : OIT_END;
  oitBeginLight();
  for (int i = 0; node != OIT_END && i <= oitLastFragment; ++i)
  {
    uint word = OIT_WORD(node);
    uvec4 first = oitLoad(word);
    node = first.w;
    if (i >= oitFirstFragment)
    {
      OITMaterial m = oitUnpackMaterial(first.yz, oitLoad(word + 1u));
      vec4 color = vec4(oitClampLight(oitLight(m, uintBitsToFloat(first.x))), m.Opacity);
      uvec2 second;
      uvec4 material = oitPackShaded(color, second);
      oitStore(word, uvec4(first.x, second, first.w));
      oitStore(word + 1u, material);
    }
  }
}
