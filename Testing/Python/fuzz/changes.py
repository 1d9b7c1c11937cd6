# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""What may change between two frames: each change edits a description, and names what of it a window that
is kept has to set again."""

import describe

# Name: (what is edited, part that is set again, edit(rng, what)).
CHANGES = {}
METHODS = {"auto": 8, "abuffer": 2, "deferred-abuffer": 1, "deferred": 0.5, "peel": 2, "dual": 1, "multilayer": 1, "bucket": 1, "bucket-pairs": 0.5,
           "bucket-adaptive": 0.5}


def change(level, part, weight=1.0):
    def add(edit):
        CHANGES[edit.__name__] = (level, part, weight, edit)
        return edit
    return add


# --- of a prop -------------------------------------------------------------------------------------------
@change("prop", "matrix", 2)
def moved(rng, prop):
    prop["matrix"] = describe.matrix(rng, "moved")


@change("prop", "matrix", 2)
def placed(rng, prop):
    prop["matrix"] = describe.matrix(rng)


@change("prop", "look", 2)
def opacity(rng, prop):
    prop["look"]["opacity"] = rng.choice(describe.OPACITIES)


@change("prop", "look")
def color(rng, prop):
    prop["look"]["color"] = describe.color(rng)


@change("prop", "look", 3)
def one_of_the_look(rng, prop):
    other = describe.look(rng)
    name = rng.choice(list(other))
    prop["look"][name] = other[name]


@change("prop", "look")
def all_of_the_look(rng, prop):
    prop["look"] = describe.look(rng)


@change("prop", "visible", 2)
def hidden_or_shown(_rng, prop):
    prop["visible"] = not prop["visible"]


@change("prop", "mesh", 3)
def points_moved(rng, prop):
    prop["shape"]["jitter"] = rng.randrange(1, 10**6)


@change("prop", "mesh")
def other_size(rng, prop):
    prop["shape"]["size"] = rng.uniform(0.2, 1.1)


@change("prop", "mesh", 2)
def other_mesh(rng, prop):
    prop["shape"] = describe.shape(rng)


@change("prop", "mesh", 2)
def values(rng, prop):
    prop["colors"]["seed"] = rng.randrange(10**6)


@change("prop", "all")
def way_of_coloring(rng, prop):
    prop["colors"] = describe.colors(rng)


@change("prop", "table", 2)
def table(rng, prop):
    prop["colors"].update(table=rng.randrange(10**6), opacity=rng.choice([0.1, 0.4, 1.0]))


@change("prop", "texture", 2)
def texture(rng, prop):
    prop["texture"] = describe.texture(rng) if rng.random() < 0.7 else None


@change("prop", "texture")
def texels(rng, prop):
    if prop["texture"]:
        prop["texture"]["seed"] = rng.randrange(10**6)


@change("prop", "planes", 2)
def planes(rng, prop):
    prop["planes"] = describe.planes(rng) if rng.random() < 0.7 else []


@change("prop", "planes")
def plane_moved(rng, prop):
    for plane in prop["planes"]:
        plane[0] = describe.vector(rng, 0.3)


@change("prop", "selection")
def selection(rng, prop):
    prop["selection"] = rng.choice([None, 0, rng.randrange(8)])


# --- of a renderer ---------------------------------------------------------------------------------------
@change("renderer", "view", 3)
def camera_moved(rng, renderer):
    renderer["camera"]["position"] = describe.vector(rng, 6.0)


@change("renderer", "view", 2)
def one_of_the_camera(rng, renderer):
    other = describe.camera(rng)
    name = rng.choice(list(other))
    renderer["camera"][name] = other[name]


@change("renderer", "view")
def other_camera(rng, renderer):
    renderer["camera"] = describe.camera(rng)


@change("renderer", "view")
def viewport(rng, renderer):
    low = [rng.choice([0.0, 0.0, rng.uniform(0.0, 0.5)]) for _ in range(2)]
    renderer["viewport"] = [*low, *(rng.choice([1.0, rng.uniform(l + 0.2, 1.0)]) for l in low)]


@change("renderer", "view")
def background(rng, renderer):
    renderer["background"] = [*describe.color(rng), rng.choice([1.0, 0.0, 0.5])]
    renderer["background2"] = describe.color(rng) if rng.random() < 0.3 else None


@change("renderer", "view", 0.5)
def sides_that_are_lit(_rng, renderer):
    renderer["two_sided"] = not renderer["two_sided"]


@change("renderer", "lights", 2)
def lights(rng, renderer):
    renderer["lights"] = [describe.light(rng) for _ in range(rng.choice([0, 1, 2]))]


@change("renderer", "lights")
def light_moved(rng, renderer):
    for light in renderer["lights"]:
        light["position"] = describe.vector(rng, 3.0)


# --- of the scene ----------------------------------------------------------------------------------------
@change("scene", "size", 2)
def size(rng, scene):
    scene["size"] = [side + rng.choice([-9, -1, 1, 8]) for side in scene["size"]]


@change("scene", "samples", 0.5)
def samples(_rng, scene):
    scene["samples"] = 4 - scene["samples"]


@change("scene", "members", 2)
def added(rng, scene):
    number = str(max([int(n) for n in scene["props"]], default=-1) + 1)
    scene["props"][number] = describe.prop(rng)
    for renderer in scene["renderers"]:
        if rng.random() < 0.8:
            renderer["props"].append(number)


@change("scene", "members", 2)
def removed(rng, scene):
    if len(scene["props"]) > 1:
        number = rng.choice(list(scene["props"]))
        del scene["props"][number]
        for renderer in scene["renderers"]:
            renderer["props"] = [n for n in renderer["props"] if n != number]


@change("scene", "members")
def order(rng, scene):
    """Not of props with selected cells: VTK crashes when they are taken out and put in again."""
    if any(prop["selection"] is not None for prop in scene["props"].values()):
        return
    for renderer in scene["renderers"]:
        rng.shuffle(renderer["props"])


@change("scene", "method", 2)
def method(rng, scene):
    scene["method"] = describe.pick(rng, METHODS)
    scene["values"] = {"TransmittanceThreshold": 0.0}


@change("scene", "values", 3)
def property_of_the_pass(rng, scene):
    """Of those that change no picture, or only a little, and of coincident layers."""
    names = {"MaximumBufferSize": [0, 2**20, 2**28], "CoincidentLayers": ["mean", "last_on_top"]}
    if scene["method"] != "multilayer":
        names["FragmentPrecision"] = ["half", "float"]
    if scene["method"] in ("auto", "abuffer"):
        names["SkipHiddenFragments"] = [True, False]
    if scene["method"] == "auto":
        for name in ("SkipInvisibleProps", "SkipSorting", "ReuseFrames"):
            names[name] = [True, False]
    name = rng.choice(list(names))
    scene["values"][name] = rng.choice(names[name])


@change("scene", None, 2)
def nothing(_rng, _scene):
    """The next frames are those before."""
