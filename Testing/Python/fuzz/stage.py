# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""A render window of a description, with a pass of vtkOIT in each renderer."""

import ctypes

import vtkoit
from props import make_prop
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkCommonTransforms import vtkPerspectiveTransform
from vtkmodules.vtkRenderingCore import vtkCamera, vtkLight, vtkRenderer
from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass, vtkToneMappingPass
from vtkoit import errors, picture
from vtkoit.windows import make_window


def gl_error():
    """The first error of the current context since the last call; 0 for none, or where that is not
    OSMesa's."""
    if vtkoit.backend() != "OSMesa":
        return 0
    library = ctypes.CDLL("libOSMesa.so.8")
    first = library.glGetError()
    for _ in range(8):  # one for each kind, at most
        if not library.glGetError():
            break
    return first


class Frame:
    """A picture, and what the passes say about it: exact (bool), words (str), layers (int), printed
    (list of str), told (bool, whether this window has printed something before), gl_error (int, 0 for
    none)."""

    def __init__(self, pixels, passes, printed, told, error):
        self.pixels = pixels
        self.told = told
        self.layers = max((p.GetMaximumDepthComplexity() for p in passes), default=0)
        self.exact = all(p.GetExact() for p in passes)
        self.words = ", ".join(p.GetAlgorithmName() for p in passes)
        self.printed = printed
        self.gl_error = error


class Stage:
    """method: str. values: of the properties of the passes, dict."""

    def __init__(self, scene, method, values):
        self.window = make_window(None, scene["size"], scene["samples"])
        self.told = False
        self.fixed = False  # whether changes leave the method as it is
        # VTK clears only what is within a viewport: without this one the rest has what was there before.
        self.window.AddRenderer(vtkRenderer())
        self.passes = {}
        self.coincident = scene["coincident"]
        self.renderers = []
        for description in scene["renderers"]:
            renderer = vtkRenderer()
            renderer.SetActiveCamera(vtkCamera())
            renderer.AutomaticLightCreationOff()
            self.window.AddRenderer(renderer)
            self.renderers.append(renderer)
            self.set_view(renderer, description)
            self.set_lights(renderer, description)
            if scene["exposure"]:
                self.expose(renderer, scene["exposure"])
        camera = self.renderers[0].GetActiveCamera()
        self.props = {number: make_prop(prop, camera) for number, prop in scene["props"].items()}
        for renderer, description in zip(self.renderers, scene["renderers"]):
            for number in description["props"]:
                renderer.AddViewProp(self.props[number].prop)
        self.set_method(method, values)

    @staticmethod
    def expose(renderer, exposure):
        """A chain of passes that draws into floats and shows 1 - exp(-exposure colour)."""
        tones = vtkToneMappingPass()
        tones.SetToneMappingType(vtkToneMappingPass.Exponential)
        tones.SetExposure(exposure)
        tones.SetDelegatePass(vtkRenderStepsPass())
        renderer.SetPass(tones)

    def set_method(self, method, values):
        """method "vtk": VTK alone, to see whether it does the same."""
        if method == "vtk":
            return
        for renderer in self.renderers:
            self.passes[renderer] = vtkoit.install(
                renderer, method, **{"CoincidentLayers": self.coincident, **values})

    def replaced(self, scene):
        """This stage with new passes."""
        self.set_method(scene["method"], scene["values"])
        return self

    def set_prop(self, number, prop, part, in_place):
        if part in ("all", "visible"):
            getattr(self.props[number], "set_" + part)(prop)
        else:
            getattr(self.props[number], "set_" + part)(prop, in_place)

    def set_scene(self, scene, part):
        """Sets a part of the whole again: "size", "samples", "members", "method", "values" or None."""
        if part == "size":
            self.window.SetSize(*scene["size"])
        elif part == "samples":
            self.window.SetMultiSamples(scene["samples"])
        elif part == "members":
            self.set_members(scene)
        elif part == "method" and not self.fixed:
            self.set_method(scene["method"], scene["values"])
        elif part == "values":
            for one in self.passes.values():
                for name, value in scene["values"].items():
                    vtkoit.passes.set_property(one, name, value)

    def set_members(self, scene):
        """Adds and removes props, and brings them into their order."""
        for number in set(scene["props"]) - set(self.props):
            self.props[number] = make_prop(scene["props"][number], self.renderers[0].GetActiveCamera())
        for renderer, description in zip(self.renderers, scene["renderers"]):
            wanted = [self.props[number].prop for number in description["props"]]
            shown = list(renderer.GetViewProps())
            kept = [prop for prop in shown if prop in wanted]
            for prop in shown:
                if prop not in wanted or kept != wanted[:len(kept)]:
                    renderer.RemoveViewProp(prop)
            for prop in wanted:
                if not renderer.HasViewProp(prop):
                    renderer.AddViewProp(prop)
        for number in set(self.props) - set(scene["props"]):
            del self.props[number]

    def set_view(self, renderer, description):
        renderer.SetViewport(*description["viewport"])
        *color, alpha = description["background"]
        renderer.SetBackground(*color)
        renderer.SetBackgroundAlpha(alpha)
        renderer.SetGradientBackground(bool(description["background2"]))
        if description["background2"]:
            renderer.SetBackground2(*description["background2"])
        renderer.SetTwoSidedLighting(description["two_sided"])
        self.set_camera(renderer.GetActiveCamera(), description["camera"])

    @staticmethod
    def set_camera(camera, description):
        camera.SetPosition(*description["position"])
        camera.SetFocalPoint(*description["focal"])
        camera.SetViewUp(*description["up"])
        camera.SetViewAngle(description["angle"])
        camera.SetParallelProjection(description["parallel"])
        camera.SetParallelScale(description["scale"])
        camera.SetClippingRange(*description["range"])
        camera.SetWindowCenter(*description["center"])
        model = vtkMatrix4x4()
        if description["model"]:
            model.DeepCopy(description["model"])
        camera.SetModelTransformMatrix(model)
        camera.SetUseExplicitProjectionTransformMatrix(description["mirrored"])
        if description["mirrored"]:  # left and right, with the range as it is
            projection = vtkPerspectiveTransform()
            projection.Perspective(description["angle"], -1.0, *description["range"])
            camera.SetExplicitProjectionTransformMatrix(projection.GetMatrix())

    @staticmethod
    def set_lights(renderer, description):
        renderer.RemoveAllLights()
        for number, values in enumerate(description["lights"] or [None]):
            light = vtkLight()
            if values is None:
                light.SetLightTypeToHeadlight()
            else:
                set_light(light, values)
            renderer.AddLight(light)
            if number == 0:
                light.SetAmbientColor(0.1, 0.1, 0.1)

    def draw(self):
        """One frame."""
        with errors.capture() as captured:
            self.window.Render()
            error = gl_error()
            pixels = picture.grab(self.window)
        told = self.told
        self.told = told or bool(captured.lines())
        return Frame(pixels, list(self.passes.values()), captured.lines(), told, error)

    def close(self):
        for renderer in self.renderers:
            self.window.RemoveRenderer(renderer)
        self.window.Finalize()


def set_light(light, values):
    {"head": light.SetLightTypeToHeadlight, "camera": light.SetLightTypeToCameraLight,
     "scene": light.SetLightTypeToSceneLight, "lamp": light.SetLightTypeToSceneLight}[values["kind"]]()
    light.SetPosition(*values["position"])
    light.SetDiffuseColor(*values["color"])
    light.SetIntensity(values["intensity"])
    light.SetPositional(values["kind"] == "lamp")
    light.SetConeAngle(40.0)
