# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The CPU reference: sorts and composites the fragments of every pixel in double precision.

compose() is the definition of correct translucency, render() applies it to VTK's surfaces as
rasterizer.py draws them: what the passes of vtkOIT should show, computed without a GPU.
"""

import collections

import numpy

from .rasterizer import rasterize

Fragments = collections.namedtuple("Fragments", "pixel depth color alpha")
Fragments.__doc__ = """Fragments in any order, n of them: pixel (int array, n; row * width + column),
depth (float array, n; smaller is closer), color (float array, n x 3) and alpha (float array, n)."""

Reference = collections.namedtuple("Reference", "pixels layers certain")
Reference.__doc__ = """A picture: pixels (float array, height x width x 4, premultiplied, in [0, 1], top
row first), layers (int array, height x width, fragments in front of what is opaque) and certain (bool
array, height x width): False where a rasteriser's rounding may decide what is seen."""

# Two fragments closer than this in window depth may swap: some units of a 24-bit depth.
DEPTH_TOLERANCE = 5e-7


def compose(colors, alphas, background):
    """Layers front to back over a background.

    colors: array, n x 3. alphas: array, n. background: (r, g, b, a), premultiplied. Returns
    (r, g, b, a), premultiplied, float64 array: C = sum of T_i a_i c_i + T C_background.
    """
    transmittance = 1.0
    result = numpy.zeros(4)
    for color, alpha in zip(colors, alphas):
        result[:3] += transmittance * alpha * numpy.asarray(color, dtype=float)
        result[3] += transmittance * alpha
        transmittance *= 1.0 - alpha
    return result + transmittance * numpy.asarray(background, dtype=float)


def composite(fragments, shape, background):
    """Fragments sorted and composited in every pixel.

    shape: (height, width). background: (r, g, b, a), premultiplied. Returns (pixels, layers, tied):
    float array height x width x 4, int array height x width, and bool array height x width, True
    where two fragments of unlike colour or opacity are closer than DEPTH_TOLERANCE.
    """
    height, width = shape
    order = numpy.lexsort((fragments.depth, fragments.pixel))
    pixel = fragments.pixel[order]
    depth = fragments.depth[order]
    color = fragments.color[order]
    alpha = fragments.alpha[order]
    layers = numpy.bincount(pixel, minlength=height * width)
    first = numpy.concatenate([[0], numpy.cumsum(layers)[:-1]])
    rank = numpy.arange(len(pixel)) - first[pixel]

    pixels = numpy.zeros((height * width, 4))
    transmittance = numpy.ones(height * width)
    tied = numpy.zeros(height * width, dtype=bool)
    for level in range(int(layers.max(initial=0))):
        now = numpy.nonzero(rank == level)[0]
        where = pixel[now]
        weight = transmittance[where] * alpha[now]
        pixels[where, :3] += weight[:, None] * color[now]
        pixels[where, 3] += weight
        if level > 0:
            close = depth[now] - depth[now - 1] < DEPTH_TOLERANCE
            unlike = (numpy.abs(color[now] - color[now - 1]).max(axis=1) > 0.01) \
                | (alpha[now] != alpha[now - 1])
            tied[where[close & unlike & (transmittance[where] > 1e-3)]] = True
        transmittance[where] *= 1.0 - alpha[now]
    pixels += transmittance[:, None] * numpy.asarray(background, dtype=float)
    return (pixels.reshape(height, width, 4), layers.reshape(shape), tied.reshape(shape))


def render(renderer, size):
    """The Reference picture of a vtkRenderer, which should have no other light than a headlight.

    size: (width, height), pixels. Drawn are its visible actors with vtkPolyDataMapper and
    triangles: their colour, opacity, ambient and diffuse coefficients, with point normals where
    they have them, on the renderer's background colour and alpha. Not scalars, textures, lines,
    specular light or clipping by the near plane.

    A pixel is not certain where rounding decides what is seen: with its centre within 1/64 pixel of
    a silhouette or an open edge, on triangles thinner than that, and where two unlike fragments are
    too close to tell their order.
    """
    width, height = size
    parts = []
    actors = renderer.GetActors()
    actors.InitTraversal()
    for _ in range(actors.GetNumberOfItems()):
        actor = actors.GetNextActor()
        if actor.GetVisibility() and actor.GetProperty().GetOpacity() > 0.0:
            parts.append(rasterize(actor, renderer.GetActiveCamera(), size))
    none = numpy.zeros(0, dtype=int)
    parts.append((none, numpy.zeros(0), numpy.zeros((0, 3)), numpy.zeros(0), none))
    *values, doubtful = [numpy.concatenate(part) for part in zip(*parts)]
    fragments = Fragments(*values)
    alpha = renderer.GetBackgroundAlpha()
    background = [c * alpha for c in renderer.GetBackground()] + [alpha]
    pixels, layers, tied = composite(fragments, (height, width), background)
    certain = ~tied
    certain.reshape(-1)[doubtful] = False
    return Reference(pixels, layers, certain)


def difference(pixels, reference, channels=slice(0, 4)):
    """(max, mean) of the differences, float, in units of 1/255.

    pixels: array of uint8, height x width x 4, premultiplied. reference: Reference, of which the
    certain pixels count. channels: slice, default red, green, blue and alpha. (0, 0) when no
    pixel is certain.
    """
    values = numpy.abs(pixels.astype(float) - 255.0 * numpy.clip(reference.pixels, 0.0, 1.0))
    values = values[reference.certain][:, channels]
    return (float(values.max()), float(values.mean())) if values.size else (0.0, 0.0)
