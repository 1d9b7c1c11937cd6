# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The command render: from files to a picture."""

import time

from . import camera, colors, contents, method_option, picture, scene, streams, volumes
from .drawn import Drawn
from .errors import Error, capture
from .hook import install
from .read import parse_raw
from .surfaces import Request
from .values import parse_numbers, parse_size, parse_whole_numbers
from .windows import headless, make_window

MULTISAMPLED = {"auto", "abuffer"}  # methods that keep the samples of a pixel apart


def run(arguments, progress):
    """Renders what the command line says; arguments: argparse.Namespace of cli. Raises Error."""
    # Everything that can be wrong with the options is found before the work.
    options = _Options(arguments)
    drawn = contents.load(arguments.inputs, options, progress)
    renderer = scene.build(drawn.surfaces, options.style, drawn.volumes)
    try:
        headless()
    except RuntimeError as error:
        raise Error(str(error)) from None
    translucency = install(renderer, options.method, **options.properties)
    camera.place(renderer, options.camera, options.up, options.zoom, arguments.parallel,
                 options.size[0] / options.size[1])
    progress.begin("rendering")
    pixels, seconds, warning = draw(renderer, options, translucency)
    picture.save(pixels, arguments.output, options.style.background is None)
    progress.clear()
    if warning:
        streams.complain("%s: warning: %s\n" % (arguments.name, warning))
    for note in drawn.notes:
        print(note)
    triangles = sum(surface.data.GetNumberOfPolys() for surface in drawn.surfaces)
    print("%s: %dx%d, %s, %s polygons, %s, %.2f s" % (
        arguments.output, *options.size, contents.count(drawn), format(triangles, ","),
        _what_was_drawn(translucency, drawn.volumes), seconds))


def _what_was_drawn(translucency, volumes_):
    layers = translucency.GetMaximumDepthComplexity()
    if translucency.GetNumberOfGeometryPasses() == 0:
        return "no translucent surface" if volumes_ else "nothing translucent"
    if layers < 0:
        return translucency.GetAlgorithmName()
    return "up to %d layers by %s" % (layers, translucency.GetAlgorithmName())


def draw(renderer, options, translucency):
    """(pixels as from picture.grab(), seconds of the frame, warning: str, empty when the method
    itself drew). options: _Options. translucency: the pass, vtkOITPass. Raises Error."""
    drawn = Drawn(options.method, translucency)
    # What sorts without the A-buffer cannot draw into several samples, which were not asked for.
    for samples in [4, 0] if options.samples is None else [options.samples]:
        with capture() as captured:
            window = make_window(renderer, options.size, samples)
            start = time.perf_counter()
            window.Render()
            seconds = time.perf_counter() - start
            pixels = picture.grab(window)
            warning = drawn.warning(window)
            window.RemoveRenderer(renderer)
            window.Finalize()
        if captured.errors(1):
            raise Error("rendering failed: %s" % captured.errors(1))
        if not drawn.unsorted():
            break
    return pixels, seconds, warning


class SceneOptions:
    """The options of the command line about what is drawn and how it looks, checked and turned into
    what the other modules take."""

    def __init__(self, arguments):
        self.size = parse_size(arguments.size)
        self.camera = camera.parse(arguments.camera)
        self.up = camera.axis(arguments.up)
        self.zoom = parse_numbers("--zoom", [arguments.zoom], 0.01, 100.0)[0]
        self.raw = parse_raw(arguments.raw) if arguments.raw else None
        self.spacing = self._spacing(arguments.spacing)
        colors.check_colormap(arguments.colormap)
        self.style = self._style(arguments)
        self.request = self._request(arguments)
        self.volume = self._volume(arguments)

    @staticmethod
    def _spacing(text):
        if text is None:
            return None
        values = parse_numbers("--spacing", [text], 1e-12, 1e12)
        if len(values) != 3:
            raise Error("--spacing %s: give X,Y,Z, the distances between samples" % text)
        return values

    @staticmethod
    def _style(arguments):
        limits = None
        if arguments.range is not None:
            limits = parse_numbers("--range", [arguments.range])
            if len(limits) != 2 or limits[0] >= limits[1]:
                raise Error("--range %s: give LOW,HIGH" % arguments.range)
        return scene.Style(
            opacities=parse_numbers("--opacity", arguments.opacity, 0.0, 1.0)
            if arguments.opacity else None,
            colors=[colors.parse_color(text) for text in arguments.color]
            if arguments.color else None,
            scalars=arguments.scalars,
            colormap=arguments.colormap,
            range=limits,
            background=None if arguments.background == "transparent"
            else colors.parse_color(arguments.background))

    @staticmethod
    def _request(arguments):
        labels = None
        if arguments.labels is not None:
            labels = parse_whole_numbers("--labels", arguments.labels, -2 ** 31, 2 ** 31 - 1) \
                if arguments.labels else []
        if labels is not None and arguments.isosurface:
            raise Error("--isosurface and --labels exclude each other; give one of them")
        if arguments.smooth < 0 or arguments.smooth > 1000:
            raise Error("--smooth %d: give 0 (none) to 1000 iterations" % arguments.smooth)
        return Request(
            isovalues=parse_numbers("--isosurface", arguments.isosurface)
            if arguments.isosurface else None,
            contour=arguments.contour, labels=labels, smoothing=arguments.smooth)

    @staticmethod
    def _volume(arguments):
        """What to make of image data, volumes.Request; None where it is not drawn as volumes."""
        if not arguments.volume:
            for name in ("opacity_function", "opacity_length", "shade"):
                if getattr(arguments, name):
                    raise Error("--%s is about volumes; give --volume, too" % name.replace("_", "-"))
            return None
        opacities = length = None
        if arguments.opacity_function:
            opacities = volumes.parse_opacities(arguments.opacity_function)
        if arguments.opacity_length is not None:
            length = parse_numbers("--opacity-length", [arguments.opacity_length], 1e-12, 1e12)[0]
        return volumes.Request(arguments.contour, opacities, length, arguments.shade)


class _Options(SceneOptions):
    """And those about the method and the picture."""

    def __init__(self, arguments):
        self.method, self.properties = method_option.parse(
            method_option.joined(arguments.method, arguments.set))
        super().__init__(arguments)
        picture.check_output(arguments.output, self.style.background is None)
        self.samples = arguments.samples
        if self.samples is None and self.method not in MULTISAMPLED:
            self.samples = 0
        if self.samples is not None and not 0 <= self.samples <= 16:
            raise Error("--samples %d: give 0 (none) to 16" % self.samples)
