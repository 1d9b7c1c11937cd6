# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The experiments of the documents that the project implements, repeated: what a frame costs and how wrong it is in
scenes like theirs."""

import numpy

from ..errors import Error, capture
from ..picture import grab
from . import accuracy, lights, rounds, scans, seedscenes, truth
from .measure import REFERENCE
from .stage import Stage

MULTILAYER = "multilayer:NumberOfLayersPerPass=%d"
HAZARDS = "multilayer:Synchronization=texture_barrier,NumberOfLayersPerPass=%d"
SHOT = "%s:MaximumNumberOfPeels=1,DepthRange=exact"
BUCKETS = ("bucket", "bucket-pairs", "bucket-adaptive")
# As theirs: one layer from each side in a pass, whatever the transmittance.
DUAL = "dual:FragmentPrecision=float,TransmittanceThreshold=0"
PEEL = "peel:TransmittanceThreshold=0"
LAYERS = (1, 2, 4, 8, 16)
LIGHTS_SIZE = (240, 135)  # of their proportions
OPACITIES = ((0.1,), (0.2,), (0.3,), (0.6,), (0.9,), (0.2, 0.5, 0.8))


def measure(size, settings, quick, progress):
    """All experiments, dict of list of dict by the name of the experiment. size: (width, height). settings:
    rounds.Settings. quick: bool, for fewer scenes."""
    study = Study(size, settings, progress)
    some = slice(0, 1) if quick else slice(None)
    return {
        "multilayer": [study.multilayer(scene) for scene in seedscenes.buildings()[some]],
        "buckets": [study.buckets(scene) for scene in scans.scenes()[some]],
        "dual": [study.dual(number) for number in LAYERS[:2] + LAYERS[2:][some]],
        "weighted": [study.weighted(opacities) for opacities in OPACITIES[some]],
        "peels": [study.peels(seedscenes.dragons())],
        "lights": [study.lights(overlap, 2 if quick else 4) for overlap in ("little", "much")[some]],
    }


class Study:
    """Makes the rows of tables."""

    def __init__(self, size, settings, progress):
        self.size = size
        self.settings = settings
        self.progress = progress

    def _stage(self, scene):
        self.progress.show("%s: making the scene" % scene.name)
        return Stage(scene, scene.size or self.size)

    def _times(self, stage, names):
        """Taken by name; a method that lacks something here is left out."""
        able = []
        for name in names:
            contender = stage.contender(name)
            with capture():
                contender.render()
            if not contender.missing() and not contender.why_other():
                able.append(name)
            contender.close()
        return rounds.take(stage, able, self.settings, self.progress)

    def _facts(self, stage, taken):
        told = next(mine.statistics for mine in taken.values() if mine.statistics)
        return {"scene": stage.scene.name, "title": stage.scene.title,
                "triangles": stage.facts()["triangles"], "layers": told.layers}

    def multilayer(self, scene):
        """Multi-layer peeling against depth peeling, without and with hazards, dict."""
        stage = self._stage(scene)
        names = [REFERENCE, PEEL] + [MULTILAYER % k for k in (4, 8, 16)] + [HAZARDS % k for k in (4, 8)]
        taken = self._times(stage, names)
        return dict(self._facts(stage, taken), methods={
            name: {"passes": taken[name].statistics.passes, "speed": _speed(taken[name], taken[PEEL])}
            for name in names[1:] if name in taken})

    def buckets(self, scene):
        """Errors and times of the three single shots, and times of what is exact, dict."""
        stage = self._stage(scene)
        shots = [SHOT % name for name in BUCKETS]
        plain = [name + ":MaximumNumberOfPeels=1" for name in BUCKETS]
        names = ["vtk-dual", "peel"] + list(BUCKETS) + shots + plain
        taken = self._times(stage, names)
        right = truth.find(stage, cross_check=False)
        result = self._facts(stage, taken)
        result["methods"] = {}
        for name in names:
            mine = {"speed": _speed(taken[name], taken["peel"]),
                    "against_dual": _speed(taken[name], taken["vtk-dual"])}
            if taken[name].statistics:
                mine["passes"] = taken[name].statistics.passes
            if name in shots:
                mine.update(_errors(stage, name, right))
            result["methods"][name] = mine
        return result

    def dual(self, number):
        """Geometry passes for so many planes, dict."""
        stage = self._stage(seedscenes.planes(number))
        taken = self._times(stage, [PEEL, DUAL, "dual:TransmittanceThreshold=0"])
        return {"layers": number, "speed": _speed(taken[DUAL], taken[PEEL]),
                "passes": {name: mine.statistics.passes for name, mine in taken.items()}}

    def weighted(self, opacities):
        """Errors of weighted average and sum, dict."""
        stage = self._stage(seedscenes.see_through(opacities))
        right = truth.find(stage, cross_check=False)
        return {"opacities": list(opacities), "layers": right.layers, "methods": {
            name: _errors(stage, name, right) for name in ("weighted-average", "weighted-sum")}}

    def lights(self, overlap, count):
        """Deferred depth peeling by passes and lights; count: int, of either."""
        self.progress.show("lights, %s overlap" % overlap)
        passes, numbers = lights.PASSES[:count], lights.LIGHTS[:count]
        here = lights.passes_by_lights(overlap, passes, numbers, size=LIGHTS_SIZE)
        return {"overlap": overlap, "passes": passes, "lights": numbers, "here": here}

    def peels(self, scene):
        """What depth peeling and dual depth peeling change from peel to peel, dict."""
        stage = self._stage(scene)
        taken = self._times(stage, ["vtk-peel", "vtk-dual", PEEL, DUAL])
        counts = _layers_of_pixels(stage)
        pixels = float(stage.size[0] * stage.size[1])
        left = [numpy.maximum(counts - peel, 0).sum() / pixels for peel in range(3)]
        changed = [(counts > 2 * peel).sum() / pixels for peel in range(3)]
        return dict(
            self._facts(stage, taken), fragments=[100.0 * x for x in left],
            changed=[100.0 * x for x in changed],
            passes={name: taken[name].statistics.passes for name in (PEEL, DUAL)},
            speed=_speed(taken[DUAL], taken[PEEL]), vtk_speed=_speed(taken["vtk-dual"], taken["vtk-peel"]))


def _speed(mine, other):
    """How many times as fast, float, by processor time, which other work disturbs least; on a GPU, whose work
    that is not, by the clock."""
    return 1.0 / rounds.ratio(mine.seconds, other.seconds)[0] if mine.cpu.sum() < 0.5 * mine.seconds.sum() \
        and other.cpu.sum() < 0.5 * other.seconds.sum() and not _is_software() \
        else 1.0 / rounds.ratio(mine.cpu, other.cpu)[0]


def _is_software():
    from . import machine

    return "llvmpipe" in machine.describe()["renderer"]


def _errors(stage, name, right):
    """Errors of a picture, dict: shares of covered pixels more than 1 and 8 steps off in percent, RMSE and mean
    difference in steps, lost fragments where that is told, exact."""
    with capture():
        contender = stage.contender(name)
        contender.render()
        contender.render()
    pixels = grab(contender.window)[..., :3]
    found = accuracy.measure(pixels, right.color, right.covered)
    difference = pixels[right.covered] - 255.0 * numpy.clip(right.color[right.covered], 0.0, 1.0)
    lost = getattr(contender.oit, "GetNumberOfLostFragments", lambda: 0)()
    exact = contender.statistics().exact
    contender.close()
    return {"over1": found.over1, "over8": found.over8, "rmse": found.rmse, "max": found.max,
            "mean": float(difference.mean()) if difference.size else 0.0, "lost": int(lost), "exact": exact}


def _layers_of_pixels(stage):
    """Fragments of each covered pixel, array of int."""
    from ..reference import fragments_of

    with capture():
        contender = stage.contender(truth.METHOD)
        contender.render()
        contender.render()
    if contender.why_other():
        raise Error("the fragments of %s cannot be counted: %s" % (stage.scene.name, contender.why_other()))
    fragments = fragments_of(contender.oit)
    contender.close()
    places = fragments[:, 1].astype(int) * stage.size[0] + fragments[:, 0].astype(int)
    return numpy.bincount(places)
