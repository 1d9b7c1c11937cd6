# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Random scenes as plain descriptions: dicts, lists, numbers and strings, from a random.Random.

A description says everything about a picture, so that build.py makes the same scene of it as often
as wanted. Nothing of VTK is here.

scene: size, samples, props (of all renderers, by number), renderers, coincident (a value of
CoincidentLayers), exposure (None: drawn into 8 bits; a number: into floats c, shown as 1 - exp(-exposure c))
renderer: viewport, background, camera, lights, props (numbers, in the order of drawing)
prop: kind, shape, colors, look, matrix, and where given texture, planes, selection, visible
"""

import math

# What a prop is, and how often. The plain ones are what a mesh is drawn by.
KINDS = {
    "mesh": 24, "dataset": 2, "composite": 3, "glyphs": 2, "assembly": 2, "points": 2, "impostors": 1,
    "follower": 1, "image": 1, "billboard": 1, "text": 1, "overlay": 0.5, "cube": 0.4, "axes": 0.4,
    "gaussians": 1,
}
SHAPES = {
    "sphere": 5, "plane": 4, "coincident": 2, "cube": 2, "cone": 1, "torus": 2, "soup": 2, "lines": 2,
    "vertices": 1, "tube": 2, "disc": 1, "strips": 1, "grid": 1, "empty": 0.3,
}
MATRICES = {
    "none": 5, "moved": 5, "turned": 5, "stretched": 3, "mirrored": 2, "sheared": 1, "flat": 0.7,
    "line": 0.3, "point": 0.3, "tiny": 0.5, "smaller": 0.5, "huge": 0.5, "divided": 0.3,
}
OPACITIES = [0.0, 1e-6, 1 / 510, 0.05, 0.2, 0.3, 0.5, 0.5, 0.7, 0.9, 0.999, 1.0]


def pick(rng, weights):
    return rng.choices(list(weights), list(weights.values()))[0]


def vector(rng, reach=1.0):
    return [rng.uniform(-reach, reach) for _ in range(3)]


def color(rng):
    """Sometimes at the ends of what is usual, rarely beyond: light adds up to more than 1 at times."""
    kind = rng.random()
    if kind < 0.2:
        return [float(rng.randrange(2)) for _ in range(3)]
    return [rng.random() for _ in range(3)]


def matrix(rng, kind=None):
    """16 numbers by rows; None for no matrix."""
    kind = kind or pick(rng, MATRICES)
    if kind == "none":
        return None
    scale = [1.0, 1.0, 1.0]
    if kind == "stretched":
        scale = [rng.uniform(0.2, 2.0) for _ in range(3)]
    elif kind == "mirrored":
        scale[rng.randrange(3)] = -rng.uniform(0.5, 1.0)
    elif kind in ("flat", "line", "point"):
        for axis in rng.sample(range(3), {"flat": 1, "line": 2, "point": 3}[kind]):
            scale[axis] = 0.0
    elif kind in ("tiny", "smaller", "huge"):
        scale = [{"tiny": 1e-12, "smaller": 1e-5, "huge": 1e4}[kind]] * 3
        if rng.random() < 0.5:  # along one axis only: a sheet thinner than float32 resolves
            scale = [1.0, 1.0, scale[0]]
            rng.shuffle(scale)
    rows = rotation(rng) if kind in ("turned", "stretched", "mirrored", "flat", "tiny") else \
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    rows = [[rows[i][j] * scale[j] for j in range(3)] for i in range(3)]
    if kind == "sheared":
        rows[rng.randrange(3)][rng.randrange(3)] += rng.uniform(-0.8, 0.8)
    at = vector(rng, 0.6)
    last = [0.0, 0.0, 0.0, rng.choice([0.5, 2.0]) if kind == "divided" else 1.0]
    return [*rows[0], at[0], *rows[1], at[1], *rows[2], at[2], *last]


def rotation(rng):
    """Rows of a rotation, from a random quaternion."""
    w, x, y, z = (rng.gauss(0.0, 1.0) for _ in range(4))
    length = math.sqrt(w * w + x * x + y * y + z * z)
    w, x, y, z = w / length, x / length, y / length, z / length
    return [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]


def shape(rng, kind=None):
    return {"kind": kind or pick(rng, SHAPES), "seed": rng.randrange(10**6), "jitter": 0,
            "size": rng.uniform(0.2, 1.1), "resolution": rng.choice([3, 4, 6, 8, 12]),
            "normals": rng.random() < 0.6, "at": vector(rng, 0.5) if rng.random() < 0.6 else [0.0] * 3}


def colors(rng):
    """How a mesh gets its colours: "none" for the property's, bytes for each point or cell, or
    numbers through a table."""
    kind = rng.choices(["none", "rgba", "rgb", "table"], [6, 2, 1, 2])[0]
    return {"kind": kind, "seed": rng.randrange(10**6), "table": rng.randrange(10**6), "by": rng.choice(["point", "cell"]),
            "opacity": rng.choice([0.3, 0.7, 1.0]), "nan": rng.random() < 0.3,
            "interpolated": rng.random() < 0.3}


def look(rng):
    chance = rng.random
    opaque = chance() < 0.15
    return {
        "color": color(rng), "opacity": 1.0 if opaque else rng.choice(OPACITIES + [chance()] * 6),
        "ambient": rng.choice([0.0, 0.0, 0.3, 1.0]), "diffuse": rng.choice([1.0, 1.0, 0.6]),
        "specular": rng.choice([0.0, 0.0, 0.4, 1.0]), "power": rng.choice([1.0, 10.0, 40.0]),
        "shading": rng.choices(["flat", "gouraud", "phong", "pbr"], [2, 4, 2, 1])[0],
        "lighting": chance() < 0.7, "metallic": chance(), "roughness": chance(),
        "representation": rng.choices(["surface", "wireframe", "points"], [12, 1, 1])[0],
        "edges": chance() < 0.1, "vertices": chance() < 0.05,
        "culling": rng.choices(["none", "back", "front"], [8, 1, 1])[0],
        "line": rng.choice([1.0, 1.0, 3.0]), "point": rng.choice([1.0, 3.0, 7.0]),
        "tubes": chance() < 0.1, "balls": chance() < 0.1,
        "back": [*color(rng), chance()] if chance() < 0.1 else None,
        "force": rng.choices([None, "opaque", "translucent"], [16, 1, 1])[0],
    }


def texture(rng):
    return {"seed": rng.randrange(10**6), "components": rng.choice([3, 4, 4]),
            "interpolate": rng.random() < 0.5, "repeat": rng.random() < 0.5}


def planes(rng):
    return [[vector(rng, 0.3), vector(rng)] for _ in range(rng.randint(1, 3))]


def prop(rng):
    chance = rng.random
    return {"kind": pick(rng, KINDS), "shape": shape(rng), "colors": colors(rng), "look": look(rng),
            "matrix": matrix(rng), "visible": chance() < 0.95, "count": rng.randint(1, 4),
            "texture": texture(rng) if chance() < 0.1 else None,
            "planes": planes(rng) if chance() < 0.1 else [],
            "selection": rng.randrange(8) if chance() < 0.05 else None}


def camera(rng):
    toward = vector(rng)
    length = math.sqrt(sum(c * c for c in toward)) or 1.0
    distance = rng.choice([4.0, 5.0, 6.0, 8.0, 0.7])
    if rng.random() < 0.4:  # along an axis: planes seen from their edges, orders by planes
        toward = [0.0, 0.0, 0.0]
        toward[rng.randrange(3)] = length = rng.choice([-1.0, 1.0])
        length = abs(length)
    return {
        "position": [distance * c / length for c in toward], "focal": vector(rng, 0.2),
        "up": [0.3, 1.0, 0.2], "angle": rng.choice([20.0, 30.0, 45.0]),
        "parallel": rng.random() < 0.3, "scale": rng.uniform(0.8, 2.0),
        "range": [0.1, 20.0] if rng.random() < 0.7 else
                 [max(0.1, distance - rng.uniform(0.2, 1.5)), distance + rng.uniform(0.3, 2.0)],
        "center": [0.0, 0.0] if rng.random() < 0.9 else [rng.uniform(-0.5, 0.5) for _ in range(2)],
        "model": matrix(rng, "moved") if rng.random() < 0.05 else None,
        "mirrored": rng.random() < 0.05,
    }


def light(rng):
    return {"kind": rng.choice(["head", "camera", "scene", "lamp"]), "position": vector(rng, 3.0),
            "color": color(rng), "intensity": rng.choice([0.4, 0.8, 1.0, 1.5])}


def brighten(rng, scene):
    """Lights far above 1, into 8 bits and into floats."""
    for one in scene["renderers"]:
        if not one["lights"] and len(scene["renderers"]) == 1:
            one["lights"] = [light(rng)]
        for values in one["lights"]:
            values["intensity"] = rng.choice([2.0, 5.0, 20.0, 50.0])


def renderer(rng, viewport, props):
    return {
        "viewport": viewport, "background": [*color(rng), rng.choice([1.0, 1.0, 0.0, 0.4])],
        "background2": color(rng) if rng.random() < 0.2 else None, "camera": camera(rng),
        "lights": [light(rng) for _ in range(rng.choice([0, 0, 0, 1, 2]))],
        "two_sided": rng.random() < 0.9, "props": props,
    }


def viewports(rng):
    """Of one renderer, or of several: beside each other, or one over a part of another."""
    return rng.choices([
        [[0.0, 0.0, 1.0, 1.0]],
        [[0.1, 0.2, 0.9, 0.95]],
        [[0.0, 0.0, 0.5, 1.0], [0.5, 0.0, 1.0, 1.0]],
        [[0.0, 0.0, 1.0, 1.0], [0.55, 0.5, 0.97, 0.9]]], [10, 2, 3, 2])[0]


def scene(rng, size):
    props = []
    for _ in range(rng.choice([1, 1, 2, 2, 3, 3, 4, 5, 6, 8])):
        new = prop(rng)
        if props and rng.random() < 0.15:  # where another one is, in other colours: coincident
            other = rng.choice(props)
            new.update({name: other[name] for name in ("kind", "shape", "matrix", "count")})
        props.append(new)
    numbers = [str(i) for i in range(len(props))]
    renderers = []
    for viewport in viewports(rng):
        mine = [n for n in numbers if rng.random() < 0.85] or numbers[:1]
        renderers.append(renderer(rng, viewport, mine))
    result = {"size": [size + rng.randrange(17), size - rng.randrange(17)],
              "samples": 4 if rng.random() < 0.08 else 0, "renderers": renderers,
              "props": dict(zip(numbers, props))}
    result["coincident"] = "last_on_top" if rng.random() < 0.3 else "mean"
    result["exposure"] = rng.choice([1.0, 0.2, 0.02]) if rng.random() < 0.2 else None
    if rng.random() < 0.3:
        brighten(rng, result)
    return settle(result)


def settle(scene):
    """The scene without what VTK itself draws in another way each time, or crashes at, opaque or not."""
    for prop in scene["props"].values():
        look, colors = prop["look"], prop["colors"]
        if prop["kind"] in ("glyphs", "gaussians", "impostors"):
            # Values of cells are read as those of points, beyond their end; values to be interpolated crash.
            colors.update(by="point", interpolated=False)
        prop.setdefault("emissive", prop["kind"] == "gaussians" and look["color"][0] < 0.5)
        if prop["kind"] == "composite" and look["force"] == "opaque":
            look["force"] = None  # its blocks are blended in the order of their addresses
        if look["edges"] or look["vertices"]:
            look["tubes"] = look["balls"] = False  # crashes
    for one in scene["renderers"][1:]:
        # A billboard has one place and size of its letters for all renderers.
        one["props"] = [n for n in one["props"] if scene["props"][n]["kind"] != "billboard"]
    if len(scene["renderers"]) > 1 or scene["renderers"][0]["viewport"] != [0.0, 0.0, 1.0, 1.0]:
        scene["exposure"] = None  # passes that draw into textures of their own cover the window
    if scene["exposure"]:
        scene["samples"] = 0
    if len(scene["renderers"]) > 1:
        # A shader that two renderers share has the lights of one of them.
        for one in scene["renderers"]:
            one["lights"] = []
    return scene
