# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces with colours and opacities in a renderer."""

import collections

from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLightKit,
    vtkPolyDataMapper,
    vtkRenderer,
)

from . import colors
from .errors import Error
from .surfaces import array_list
from .volumes import actor_of

Style = collections.namedtuple("Style", "opacities colors scalars colormap range background")
Style.__doc__ = """opacities: list of float, one a surface, the last for the rest; None for a choice.
colors: list of (r, g, b), repeated; None for a choice. scalars: str, array that colours the surfaces,
or None. colormap: str. range: (low, high), float, of the colours, or None for the data's.
background: (r, g, b), or None for transparent."""


def build(surfaces, style, volumes=()):
    """A vtkRenderer with one vtkActor for each Surface, in their order, and one vtkVolume for each
    volumes.Volume. Raises Error."""
    renderer = vtkRenderer()
    if style.background is None:
        renderer.SetBackground(0, 0, 0)
        renderer.SetBackgroundAlpha(0.0)
    else:
        renderer.SetBackground(*style.background)
        renderer.SetBackgroundAlpha(1.0)
    # Lights that stay with the camera: shape is seen from every side.
    kit = vtkLightKit()
    kit.SetKeyLightIntensity(0.9)
    kit.AddLightsToRenderer(renderer)

    opacities = _opacities(surfaces, style.opacities)
    table = _scalar_table(surfaces, style) if style.scalars else None
    for i, surface in enumerate(surfaces):
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(surface.data)
        if table is None or not _color_by(mapper, surface.data, style.scalars, table):
            mapper.ScalarVisibilityOff()
        actor = vtkActor()
        actor.SetMapper(mapper)
        material = actor.GetProperty()
        material.SetColor(*_color(surfaces, i, style))
        material.SetOpacity(opacities[i])
        material.SetInterpolationToPhong()
        material.SetSpecular(0.15)
        material.SetSpecularPower(30)
        material.SetPointSize(3)
        renderer.AddActor(actor)
    for volume in volumes:
        renderer.AddVolume(actor_of(volume, style.colormap, style.range))
    return renderer


def opacity_of(number, count):
    """The opacity of surface number (int, from 0) of count when the user gives none, float."""
    if count == 1:
        return 0.5
    if count <= 6:
        return 0.25 + 0.35 * number / (count - 1)
    return 0.25


def _opacities(surfaces, given):
    if given:
        return [given[min(i, len(given) - 1)] for i in range(len(surfaces))]
    # Higher isovalues are most often further inside: more opaque, so that they are seen.
    values = sorted({s.value for s in surfaces if s.kind == "isosurface"})
    result = []
    for surface in surfaces:
        if surface.kind == "isosurface":
            result.append(opacity_of(values.index(surface.value), len(values)))
        else:
            result.append(opacity_of(0, len(surfaces)) if len(surfaces) == 1 else 0.35)
    return result


def _color(surfaces, number, style):
    if style.colors:
        return style.colors[number % len(style.colors)]
    values = sorted({s.value for s in surfaces if s.kind == "isosurface"})
    if surfaces[number].kind == "isosurface" and len(values) > 1:
        # The order of the colours is the order of the values; the map's two ends are too dark
        # and too bright to show shape.
        position = values.index(surfaces[number].value) / (len(values) - 1)
        return colors.sequential_color(0.15 + 0.75 * position, style.colormap)
    return colors.palette_color(number)


def _color_by(mapper, data, name, table):
    """Colours a mapper by the array of this name; False when the data does not have it."""
    if data.GetPointData().HasArray(name):
        mapper.SetScalarModeToUsePointFieldData()
        array = data.GetPointData().GetArray(name)
    elif data.GetCellData().HasArray(name):
        mapper.SetScalarModeToUseCellFieldData()
        array = data.GetCellData().GetArray(name)
    else:
        return False
    if array is None:
        return False
    mapper.SelectColorArray(name)
    mapper.SetColorModeToMapScalars()
    mapper.SetLookupTable(table)
    mapper.UseLookupTableScalarRangeOn()
    mapper.ScalarVisibilityOn()
    mapper.InterpolateScalarsBeforeMappingOff()
    return True


def _scalar_table(surfaces, style):
    """The colour map of style.scalars over the range of all surfaces, magnitudes of vectors."""
    low, high, vectors = float("inf"), float("-inf"), False
    for surface in surfaces:
        for attributes in (surface.data.GetPointData(), surface.data.GetCellData()):
            array = attributes.GetArray(style.scalars)
            if array is not None:
                vectors = vectors or array.GetNumberOfComponents() > 1
                bounds = array.GetRange(-1 if array.GetNumberOfComponents() > 1 else 0)
                low, high = min(low, bounds[0]), max(high, bounds[1])
    if low > high:
        raise Error("no surface has the scalars %s; there are: %s"
                    % (style.scalars, array_list([surface.data for surface in surfaces])))
    if style.range:
        low, high = style.range
    table = colors.transfer_function(style.colormap, low, high)
    if vectors:
        table.SetVectorModeToMagnitude()
    return table
