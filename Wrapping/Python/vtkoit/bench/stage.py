# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""A scene as the methods get it: the same props, camera and background in a renderer for each."""

import copy

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk

from ..picture import grab
from ..windows import make_window
from .contenders import Contender, parse
from .scene import Cloud, Part, actor_of, append, fill, surfaces_of, triangles_of


def volumes_of(renderer):
    """The vtkVolumes of a vtkRenderer, list."""
    props = renderer.GetVolumes()
    props.InitTraversal()
    return [props.GetNextVolume() for _ in range(props.GetNumberOfItems())]


class Stage:
    """A Scene of the laboratory."""

    def __init__(self, scene, size):
        """scene: Scene, whose parts are made here. size: (width, height), pixels."""
        self.scene = scene
        self.size = size
        self.parts = scene.make()

    def renderer(self):
        """A new vtkRenderer with the props and the camera."""
        return fill(self.scene, self.parts)

    def facts(self):
        """What a result tells of the scene, dict."""
        return {"scene": self.scene.name, "title": self.scene.title, "family": self.scene.family,
                "value": self.scene.value, "width": self.size[0], "height": self.size[1],
                "triangles": int(triangles_of(self.parts)), "props": len(self.parts)}

    def why_not(self, name):
        """Why a contender (str) cannot draw this, str; empty when it can."""
        if parse(name)[0] == "vtk-sort" and any(
                part.kind in ("spheres", "sticks") or part.texture for part in self._translucent()):
            return "sorts polygons of one colour a prop, not textures or impostors"
        return ""

    def contender(self, name):
        """A new Contender."""
        if parse(name)[0] != "vtk-sort":
            return Contender(name, self.renderer(), self.size)
        translucent = self._translucent()
        renderer = fill(self.scene, [part for part in self.parts if part not in translucent])
        if translucent:
            renderer.AddActor(_sorted_actor(translucent, renderer.GetActiveCamera()))
        self.scene.place(renderer)
        return Contender(name, renderer, self.size)

    def behind(self, background_alpha=1.0):
        """The picture without the translucent props and the volumes, array of uint8, height x width x 4, top row
        first. background_alpha: float, of the background."""
        renderer = self.renderer()
        renderer.SetBackgroundAlpha(background_alpha)
        actors = renderer.GetActors()
        actors.InitTraversal()
        for _ in range(actors.GetNumberOfItems()):
            actor = actors.GetNextActor()
            if actor.HasTranslucentPolygonalGeometry():
                actor.SetVisibility(False)
        for volume in volumes_of(renderer):
            volume.SetVisibility(False)
        window = make_window(renderer, self.size)
        window.Render()
        pixels = grab(window)
        window.RemoveRenderer(renderer)
        window.Finalize()
        return pixels

    def has_volumes(self):
        """Whether there are volumes in it, bool."""
        return bool(volumes_of(self.renderer()))

    def finer(self, factor):
        """The same Stage, whose volumes get so many times the samples, int."""
        result = copy.copy(self)

        def renderer():
            made = self.renderer()
            for volume in volumes_of(made):
                mapper = volume.GetMapper()
                mapper.SetSampleDistance(mapper.GetSampleDistance() / factor)
            return made

        result.renderer = renderer
        return result

    def _translucent(self):
        return [part for part in surfaces_of(self.parts) if part.opacity < 1.0 or part.texture]


class SurfaceStage(Stage):
    """What files hold, with the look and the view of the command render."""

    def __init__(self, name, title, make_renderer, surfaces, size, volumes=()):
        """name, title: str. make_renderer: function without arguments that returns a new vtkRenderer.
        surfaces: list of surfaces.Surface. size: (width, height), pixels. volumes: list of volumes.Volume."""
        # pylint: disable=super-init-not-called
        self.size = size
        self.make_renderer = make_renderer
        self.parts = [Part(surface.data, (1, 1, 1), 1.0) for surface in surfaces] \
            + [Cloud(volume, None, None, None) for volume in volumes]
        self.name = name
        self.title = title

    def renderer(self):
        return self.make_renderer()

    def facts(self):
        return {"scene": self.name, "title": self.title, "family": None, "value": None,
                "width": self.size[0], "height": self.size[1],
                "triangles": int(triangles_of(self.parts)), "props": len(self.parts)}

    def why_not(self, name):
        return "sorts props of one colour each" if parse(name)[0] == "vtk-sort" else ""

    def contender(self, name):
        return Contender(name, self.renderer(), self.size)


def _sorted_actor(parts, camera):
    """One actor of all parts, whose polygons are sorted by depth for each frame."""
    from vtkmodules.vtkCommonDataModel import vtkPolyData
    from vtkmodules.vtkFiltersHybrid import vtkDepthSortPolyData

    colored = []
    for part in parts:
        data = vtkPolyData()
        data.SetPoints(part.data.GetPoints())
        data.SetPolys(part.data.GetPolys())
        data.SetStrips(part.data.GetStrips())
        data.GetPointData().SetNormals(part.data.GetPointData().GetNormals())
        rgba = numpy.rint(255 * numpy.array([*part.color, part.opacity])).astype(numpy.uint8)
        array = numpy_to_vtk(numpy.tile(rgba, (data.GetNumberOfPoints(), 1)), deep=True)
        array.SetName("colors")
        data.GetPointData().SetScalars(array)
        colored.append(data)
    sort = vtkDepthSortPolyData()
    sort.SetInputData(append(colored))
    sort.SetDirectionToBackToFront()
    sort.SetDepthSortModeToBoundsCenter()
    sort.SetCamera(camera)
    actor = actor_of(parts[0])
    actor.GetProperty().SetOpacity(1.0)
    mapper = actor.GetMapper()
    mapper.SetInputConnection(sort.GetOutputPort())
    mapper.ScalarVisibilityOn()
    mapper.SetColorModeToDirectScalars()
    actor.ForceTranslucentOn()
    return actor
