# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Colours by name, palettes for several surfaces, and colour maps for scalars."""

import re

from vtkmodules.vtkRenderingCore import vtkColorTransferFunction

from .errors import Error

# Nine stops each, sampled from the maps that bear the names (viridis, plasma and inferno are CC0;
# coolwarm is Moreland's diverging map).
COLORMAPS = {
    "viridis": "440154 482878 3e4989 31688e 26828e 1f9e89 35b779 6ece58 fde725",
    "plasma": "0d0887 4c02a1 7e03a8 aa2395 cc4778 e66c5c f89540 fdc527 f0f921",
    "inferno": "000004 1b0c41 4a0c6b 781c6d a52c60 cf4446 ed6925 fb9b06 fcffa4",
    "coolwarm": "3b4cc0 6788ee 9abbff c9d7f0 dddddd f7b89c e7745b d24b40 b40426",
    "gray": "000000 202020 404040 606060 808080 9f9f9f bfbfbf dfdfdf ffffff",
    "rainbow": "0000ff 0080ff 00ffff 00ff80 00ff00 80ff00 ffff00 ff8000 ff0000",
}

# Told apart by people with colour-blindness too: Okabe and Ito, Color universal design, 2008,
# without black; then lighter and darker ones for more surfaces.
PALETTE = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#f0e442",
           "#882255", "#44aa99", "#aa4499", "#ddcc77", "#332288", "#999933", "#cc6677",
           "#117733", "#88ccee"]


def parse_color(text):
    """(red, green, blue), float in [0, 1], of a str: a name, #rrggbb, or r,g,b. Raises Error."""
    match = re.fullmatch(r"#?([0-9a-fA-F]{6})", text)
    if match:
        return tuple(int(match.group(1)[i:i + 2], 16) / 255.0 for i in (0, 2, 4))
    if "," in text:
        try:
            values = tuple(float(part) for part in text.split(","))
        except ValueError:
            values = ()
        if len(values) == 3 and all(0.0 <= value <= 1.0 for value in values):
            return values
        raise Error("colour %s: give three numbers from 0 to 1, such as 0.9,0.2,0.1" % text)
    from vtkmodules.vtkCommonColor import vtkNamedColors

    names = vtkNamedColors()
    plain = re.sub(r"[\s_-]", "", text.lower())
    if not plain or not names.ColorExists(plain):
        raise Error("colour %s: unknown; give a name of the web's colours (tomato, steelblue), "
                    "#rrggbb, or r,g,b from 0 to 1" % text)
    return tuple(names.GetColor3d(plain))


def palette_color(number):
    """The colour of surface number (int, from 0) when the user gives none, (r, g, b) in [0, 1]."""
    color = parse_color(PALETTE[number % len(PALETTE)])
    # The second round is lighter, the third darker.
    step = number // len(PALETTE) % 3
    target, share = [(0.0, 0.0), (1.0, 0.45), (0.0, 0.4)][step]
    return tuple(c + share * (target - c) for c in color)


def sequential_color(fraction, name="viridis"):
    """The colour of a fraction in [0, 1] of a colour map, (r, g, b)."""
    return tuple(transfer_function(name, 0.0, 1.0).GetColor(min(max(fraction, 0.0), 1.0)))


def check_colormap(name):
    """Raises Error for the name (str) of an unknown colour map; -r at its end reverses a map."""
    if name[:-2] in COLORMAPS and name.endswith("-r") or name in COLORMAPS:
        return
    raise Error("colour map %s: unknown; there are: %s (each also reversed: viridis-r)"
                % (name, " ".join(COLORMAPS)))


def transfer_function(name, low, high):
    """The vtkColorTransferFunction of a colour map over the range low to high, float."""
    check_colormap(name)
    reverse = name not in COLORMAPS
    stops = COLORMAPS[name[:-2] if reverse else name].split()
    stops = stops[::-1] if reverse else stops
    function = vtkColorTransferFunction()
    function.SetColorSpaceToLab()
    if high <= low:
        high = low + 1.0
    for i, stop in enumerate(stops):
        function.AddRGBPoint(low + (high - low) * i / (len(stops) - 1), *parse_color(stop))
    return function
