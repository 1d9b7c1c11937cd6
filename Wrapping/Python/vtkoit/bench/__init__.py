# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The accuracy and speed laboratory: what a frame costs and how wrong it is, for any method and scene,
next to VTK's own methods.

scene.py          what a scene is made of
families.py       procedural scenes that change one thing at a time
sciviz.py         scenes as they are drawn in practice, data.py those of data files
clouds.py         scenes of volumes
catalogue.py      all scenes by name
stage.py          a scene as every method gets it
contenders.py     all methods by name, each in a window of its own
gpu.py            timer queries of a GPU
measure.py        interleaved frames, medians and spread
truth.py          the right picture, in double precision by ../reference.py from captured fragments
accuracy.py       errors of a picture against the truth
record.py         what is kept of a method in a scene
store.py          results on disk, so that an interrupted run can go on
tables.py         text, CSV and JSON; machine.py their header
plots.py          diagrams and contact sheets, by matplotlib
document.py       the page of the documentation
rounds.py         frames in turns without errors, for
skips.py          what each skip saves
costs.py          what the automatic choice rests on
growth.py         how the cost grows
first.py          what the first picture costs
changes.py        what data that change cost
seeds.py          the experiments of the documents that the project implements, scans.py and seedscenes.py their
                  scenes, seedpage.py their page
studies.py        the command bench with one of these
run.py            the command bench
"""
