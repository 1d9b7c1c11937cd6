# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Isosurfaces inside each other, in the right order, in a file.

    python3 nested_isosurfaces.py isosurfaces.png
"""

import sys

import pyvista as pv

plotter = pv.Plotter(off_screen=True, window_size=[400, 400])
plotter.background_color = "white"
surfaces = pv.Wavelet().contour([90, 120, 150, 180, 210, 240])
plotter.add_mesh(surfaces, cmap="viridis", opacity=0.35, smooth_shading=True, show_scalar_bar=False)
plotter.oit.enable()
plotter.show(auto_close=False)
plotter.screenshot(sys.argv[1])
print(plotter.oit.report())
plotter.close()
