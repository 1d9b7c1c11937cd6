# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The same scene by VTK alone, left, and by vtkOIT, right: one subplot has a method of its own.

    python3 side_by_side.py side_by_side.png
"""

import sys

import pyvista as pv
import vtkoit

plotter = pv.Plotter(off_screen=True, shape=(1, 2), window_size=[600, 300])
for column in (0, 1):
    plotter.subplot(0, column)
    for i, color in enumerate(["tomato", "mediumseagreen", "royalblue", "gold"]):
        plotter.add_mesh(pv.Sphere(radius=1.0 - 0.2 * i), color=color, opacity=0.4)
    plotter.add_mesh(pv.Cube(x_length=2.6, y_length=0.5, z_length=0.5), color="gray", opacity=0.6)
plotter.link_views()

last = plotter.renderers[1]
vtkoit.install(last, "abuffer")
plotter.show(auto_close=False)
plotter.screenshot(sys.argv[1])
print("%d fragments, up to %d in a pixel" % (
    vtkoit.installed(last).GetNumberOfFragments(), vtkoit.installed(last).GetMaximumDepthComplexity()))
plotter.close()
