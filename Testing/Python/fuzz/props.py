# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Props from descriptions. A prop is made and changed by the same functions, one for each part of its
description, so that a change means the same in a window that is kept and in a new one."""

from meshes import make_image, make_mesh, make_table
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import (
    vtkMultiBlockDataSet, vtkPlane, vtkPlaneCollection, vtkSelection, vtkSelectionNode)
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkFiltersSources import vtkConeSource
from vtkmodules.vtkInteractionStyle import vtkInteractorStyleImage  # noqa: F401 (registers text)
from vtkmodules.vtkRenderingAnnotation import vtkAnnotatedCubeActor, vtkAxesActor
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkAssembly, vtkBillboardTextActor3D, vtkCompositeDataDisplayAttributes, vtkDataSetMapper,
    vtkFollower, vtkGlyph3DMapper, vtkImageActor, vtkPointGaussianMapper, vtkPolyDataMapper, vtkProperty,
    vtkTextActor, vtkTextActor3D, vtkTexture)
import vtkmodules.vtkRenderingFreeType  # noqa: F401 (draws text)
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLSphereMapper

try:
    from vtkmodules.vtkRenderingOpenGL2 import vtkCompositePolyDataMapper2 as CompositeMapper
except ImportError:  # from VTK 9.3 on
    from vtkmodules.vtkRenderingCore import vtkCompositePolyDataMapper as CompositeMapper

# Kinds that are an actor with a mapper of one mesh.
MESHES = ("mesh", "dataset", "glyphs", "assembly", "points", "impostors", "follower", "gaussians")


def make_prop(prop, camera=None):
    """The Prop of a description; camera: the vtkCamera that a follower follows."""
    makers = {"composite": Composite, "image": Image, "billboard": Text, "text": Text, "overlay": Text,
              "cube": Parts, "axes": Parts}
    return makers.get(prop["kind"], Mesh)(prop, camera)


class Prop:
    """What every kind has: its matrix, and whether it is seen. self.prop is the vtkProp."""

    def set_all(self, prop):
        self.set_matrix(prop)
        self.set_visible(prop)

    def set_visible(self, prop):
        self.prop.SetVisibility(prop["visible"])

    def set_matrix(self, prop, in_place=False):
        """in_place: the elements of the matrix that the prop has, as by a transform that moves."""
        values = prop["matrix"] or [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
        old = self.moved.GetUserMatrix()
        if in_place and old:
            old.DeepCopy(values)
        elif prop["matrix"]:
            matrix = vtkMatrix4x4()
            matrix.DeepCopy(values)
            self.moved.SetUserMatrix(matrix)
        else:
            self.moved.SetUserMatrix(None)

    @property
    def moved(self):
        return self.prop

    def __getattr__(self, name):
        """What a kind does not have cannot be set: nothing."""
        if name.startswith("set_"):
            return lambda prop, in_place=False: None
        raise AttributeError(name)


class Mesh(Prop):
    """An actor, and a mapper of one mesh."""

    def __init__(self, prop, camera):
        kind = prop["kind"]
        self.prop = self.actor = vtkFollower() if kind == "follower" else vtkActor()
        if kind == "follower":
            self.actor.SetCamera(camera)
        self.mapper = {"dataset": vtkDataSetMapper, "glyphs": vtkGlyph3DMapper, "impostors": vtkOpenGLSphereMapper,
                       "gaussians": vtkPointGaussianMapper}.get(kind, vtkPolyDataMapper)()
        self.actor.SetMapper(self.mapper)
        if kind == "assembly":
            self.prop = vtkAssembly()
            self.prop.AddPart(self.actor)
            for i in range(1, prop["count"]):
                part = vtkActor()
                part.SetMapper(self.mapper)
                part.SetProperty(self.actor.GetProperty())
                part.SetPosition(0.3 * i, -0.1 * i, 0.2 * i)
                part.RotateX(40.0 * i)
                self.prop.AddPart(part)
        elif kind == "glyphs":
            cone = vtkConeSource()
            self.mapper.SetSourceConnection(cone.GetOutputPort())
            self.mapper.SetScaleFactor(0.3)
            self.mapper.ScalingOff()
        elif kind == "impostors":
            self.mapper.SetRadius(0.25)
        elif kind == "gaussians":
            self.mapper.SetScaleFactor(0.15)
            self.mapper.SetEmissive(prop["emissive"])
        self.mesh = None
        self.set_all(prop)

    def set_all(self, prop):
        super().set_all(prop)
        self.set_mesh(prop)
        self.set_table(prop)
        self.set_look(prop)
        self.set_texture(prop)
        self.set_planes(prop)
        self.set_selection(prop)

    def set_mesh(self, prop, in_place=False):
        """in_place: the same vtkPolyData, and where nothing but points have moved the same array."""
        new = make_mesh(prop["shape"], prop["colors"])
        if not in_place or not self.mesh:
            self.mesh = new
            self.mapper.SetInputDataObject(new)
            return
        old = self.mesh.GetPoints()
        if old and new.GetPoints() and old.GetNumberOfPoints() == new.GetNumberOfPoints() and \
                new.GetPolys().GetNumberOfConnectivityIds() == self.mesh.GetPolys().GetNumberOfConnectivityIds():
            vtk_to_numpy(old.GetData())[:] = vtk_to_numpy(new.GetPoints().GetData())
            old.GetData().Modified()
            old.Modified()
            for data, other in ((self.mesh.GetPointData(), new.GetPointData()),
                                (self.mesh.GetCellData(), new.GetCellData())):
                data.ShallowCopy(other)
            self.mesh.SetPolys(new.GetPolys())
            self.mesh.Modified()
        else:
            self.mesh.ShallowCopy(new)

    def set_table(self, prop, in_place=False):
        colors = prop["colors"]
        new = make_table(colors)
        old = self.mapper.GetLookupTable() if in_place else None
        if old and old.IsA("vtkLookupTable"):
            old.DeepCopy(new)
            old.Modified()
        else:
            self.mapper.SetLookupTable(new)
        self.mapper.SetInterpolateScalarsBeforeMapping(colors["interpolated"])
        self.mapper.SetScalarVisibility(colors["kind"] != "none")
        self.mapper.SetUseLookupTableScalarRange(True)

    def set_look(self, prop, in_place=True):
        """Not in place: another vtkProperty."""
        look = prop["look"]
        new = self.actor.GetProperty() if in_place else vtkProperty()
        set_property(new, look)
        self.actor.SetProperty(new)
        back = None
        if look["back"]:
            back = vtkProperty()
            set_property(back, look)
            back.SetColor(*look["back"][:3])
            back.SetOpacity(look["back"][3])
        self.actor.SetBackfaceProperty(back)
        for part in self.parts():
            part.SetProperty(new)
            part.SetBackfaceProperty(back)
        self.actor.SetForceOpaque(look["force"] == "opaque")
        self.actor.SetForceTranslucent(look["force"] == "translucent")

    def parts(self):
        """Actors that have the same mapper. They look alike: where only some of them have a texture, VTK
        itself draws another picture in every frame, and where only some have a back, it crashes."""
        if self.prop is self.actor:
            return []
        parts = self.prop.GetParts()
        return [parts.GetItemAsObject(i) for i in range(parts.GetNumberOfItems())]

    def set_texture(self, prop, in_place=False):
        """Marks the properties as modified: VTK's mappers do not see that a texture has gone, and go on
        with the shader that samples it."""
        for actor in [self.actor, *self.parts()]:
            actor.GetProperty().Modified()
        texture = prop["texture"]
        if not texture or prop["kind"] in ("glyphs", "impostors", "gaussians"):
            for actor in [self.actor, *self.parts()]:
                actor.SetTexture(None)
            return
        image = make_image(texture)
        old = self.actor.GetTexture()
        if in_place and old and old.GetInput():
            old.GetInput().ShallowCopy(image)
            old.GetInput().Modified()
        else:
            old = vtkTexture()
            old.SetInputData(image)
        old.SetInterpolate(texture["interpolate"])
        old.SetRepeat(texture["repeat"])
        for actor in [self.actor, *self.parts()]:
            actor.SetTexture(old)

    def set_planes(self, prop, in_place=False):
        old = self.mapper.GetClippingPlanes()
        if in_place and old and old.GetNumberOfItems() == len(prop["planes"]):
            for i, (origin, normal) in enumerate(prop["planes"]):
                set_plane(old.GetItem(i), origin, normal)
            return
        planes = vtkPlaneCollection()
        for origin, normal in prop["planes"]:
            plane = vtkPlane()
            set_plane(plane, origin, normal)
            planes.AddItem(plane)
        if prop["planes"] or old:
            self.mapper.SetClippingPlanes(planes)

    def set_selection(self, prop, in_place=False):
        """Cells that the mapper draws again, on top. Not every mapper of every VTK knows them."""
        if not hasattr(self.mapper, "SetSelection"):
            return
        if prop["selection"] is None:
            self.mapper.SetSelection(None)
            return
        ids = vtkIdTypeArray()
        ids.InsertNextValue(prop["selection"])
        node = vtkSelectionNode()
        node.SetContentType(vtkSelectionNode.INDICES)
        node.SetFieldType(vtkSelectionNode.CELL)
        node.SetSelectionList(ids)
        selection = vtkSelection()
        selection.AddNode(node)
        self.mapper.SetSelection(selection)


class Composite(Mesh):
    """Blocks of one shape beside each other, drawn by one mapper; attributes of blocks of their own."""

    def __init__(self, prop, _camera):
        self.prop = self.actor = vtkActor()
        self.mapper = CompositeMapper()
        self.actor.SetMapper(self.mapper)
        self.mesh = None
        self.set_all(prop)

    def set_mesh(self, prop, in_place=False):
        if not in_place or not self.mesh:
            self.mesh = vtkMultiBlockDataSet()
            self.mapper.SetInputDataObject(self.mesh)
        self.mesh.SetNumberOfBlocks(prop["count"])
        for i in range(prop["count"]):
            shape = dict(prop["shape"], at=[c + 0.25 * i for c in prop["shape"]["at"]])
            if shape["kind"] == "empty":  # a mapper of nothing asks for a range of nothing
                shape["kind"] = "plane"
            self.mesh.SetBlock(i, make_mesh(shape, prop["colors"]))
        self.mesh.Modified()
        self.set_blocks(prop)

    def set_blocks(self, prop, in_place=False):
        """Opacity, colour and visibility of single blocks."""
        old = self.mapper.GetCompositeDataDisplayAttributes() if in_place else None
        attributes = old or vtkCompositeDataDisplayAttributes()
        seed = prop["colors"]["seed"]
        for i in range(prop["count"]):
            block = self.mesh.GetBlock(i)
            attributes.SetBlockVisibility(block, not (seed >> i) % 7 == 0)
            if (seed >> i) % 3 == 1:
                attributes.SetBlockOpacity(block, 0.15 + 0.2 * i)
                attributes.SetBlockColor(block, ((seed >> 3) % 5 / 4, i / 4, 0.5))
        self.mapper.SetCompositeDataDisplayAttributes(attributes)

    def set_texture(self, prop, in_place=False):
        pass

    def set_selection(self, prop, in_place=False):
        pass


class Image(Prop):
    """A slice of an image with opacities."""

    def __init__(self, prop, _camera):
        self.prop = vtkImageActor()
        self.set_all(prop)

    def set_all(self, prop):
        super().set_all(prop)
        self.set_look(prop)
        self.set_mesh(prop)

    def set_mesh(self, prop, in_place=False):
        image = make_image({"seed": prop["shape"]["seed"] + prop["shape"]["jitter"], "components": 4})
        image.SetSpacing(0.3, 0.3, 0.3)
        old = self.prop.GetInput() if in_place else None
        if old:
            vtk_to_numpy(old.GetPointData().GetScalars())[:] = vtk_to_numpy(image.GetPointData().GetScalars())
            old.GetPointData().GetScalars().Modified()
            old.Modified()
        else:
            self.prop.SetInputData(image)

    def set_look(self, prop, in_place=True):
        self.prop.SetOpacity(prop["look"]["opacity"])


class Text(Prop):
    def __init__(self, prop, _camera):
        self.prop = {"billboard": vtkBillboardTextActor3D, "text": vtkTextActor3D, "overlay": vtkTextActor}[
            prop["kind"]]()
        self.prop.SetInput("abc")
        self.set_all(prop)

    def set_all(self, prop):
        super().set_all(prop)
        self.set_look(prop)

    def set_look(self, prop, in_place=True):
        text = self.prop.GetTextProperty()
        text.SetFontSize(18)
        text.SetColor(*prop["look"]["color"])
        text.SetOpacity(prop["look"]["opacity"])
        text.SetBackgroundColor(0.9, 0.8, 0.1)
        text.SetBackgroundOpacity(prop["look"]["metallic"])

    def set_matrix(self, prop, in_place=False):
        """Text has a place only: as large as its letters, and no matrix may make it larger."""
        at = (prop["matrix"] or [0.0] * 16)[3:12:4]
        if prop["kind"] == "overlay":
            self.prop.SetPosition(12 + 20 * at[0], 12 + 20 * at[1])
        else:
            self.prop.SetPosition(*at)
            if prop["kind"] == "text":
                self.prop.SetScale(0.04)


class Parts(Prop):
    """Props that draw parts of their own without handing on their keys."""

    def __init__(self, prop, _camera):
        self.prop = vtkAnnotatedCubeActor() if prop["kind"] == "cube" else vtkAxesActor()
        self.set_all(prop)

    def set_all(self, prop):
        super().set_all(prop)
        self.set_look(prop)

    def set_look(self, prop, in_place=True):
        opacity = prop["look"]["opacity"]
        if prop["kind"] == "cube":
            self.prop.GetCubeProperty().SetOpacity(opacity)
            self.prop.GetCubeProperty().SetColor(*prop["look"]["color"])
        else:
            self.prop.SetAxisLabels(False)
            self.prop.GetXAxisShaftProperty().SetOpacity(opacity)
            self.prop.GetYAxisTipProperty().SetOpacity(opacity)

    def set_matrix(self, prop, in_place=False):
        if prop["kind"] == "axes":
            super().set_matrix(prop, in_place)


def set_plane(plane, origin, normal):
    plane.SetOrigin(*origin)
    plane.SetNormal(*normal)


def set_property(target, look):
    target.SetColor(*look["color"])
    for name in ("Opacity", "Ambient", "Diffuse", "Specular", "Lighting", "Metallic", "Roughness"):
        getattr(target, "Set" + name)(look[name.lower()])
    target.SetSpecularPower(look["power"])
    target.SetInterpolation({"flat": 0, "gouraud": 1, "phong": 2, "pbr": 3}[look["shading"]])
    target.SetRepresentation({"points": 0, "wireframe": 1, "surface": 2}[look["representation"]])
    target.SetEdgeVisibility(look["edges"])
    target.SetVertexVisibility(look["vertices"])
    target.SetBackfaceCulling(look["culling"] == "back")
    target.SetFrontfaceCulling(look["culling"] == "front")
    target.SetLineWidth(look["line"])
    target.SetPointSize(look["point"])
    target.SetRenderLinesAsTubes(look["tubes"])
    target.SetRenderPointsAsSpheres(look["balls"])
