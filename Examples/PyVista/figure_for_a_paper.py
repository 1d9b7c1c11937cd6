# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Supersampling, ambient occlusion, and a transparent background: a figure to put on any page.

    python3 figure_for_a_paper.py figure.png
"""

import sys

import pyvista as pv

plotter = pv.Plotter(off_screen=True, window_size=[400, 400])
bumps = pv.Sphere(radius=0.9, theta_resolution=60, phi_resolution=60)
bumps["height"] = bumps.points[:, 2]
plotter.add_mesh(pv.ParametricTorus(ringradius=0.45, crosssectionradius=0.15), color="firebrick")
plotter.add_mesh(bumps, cmap="coolwarm", opacity=[0.2, 0.6, 0.2], show_scalar_bar=False)
plotter.add_mesh(pv.Icosahedron(radius=1.3), color="white", opacity=0.25, show_edges=True)
plotter.enable_ssao(radius=0.5, kernel_size=32)
plotter.enable_anti_aliasing("ssaa")
plotter.oit.enable()
plotter.show(auto_close=False)
plotter.screenshot(sys.argv[1], transparent_background=True)
plotter.close()
