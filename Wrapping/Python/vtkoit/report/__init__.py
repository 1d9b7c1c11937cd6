# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pages to look at: pictures of several methods under a slider, tables and the machine in one file.

page.py     what a page is made of, and its file
page.html   the frame of it, page.css how it looks, page.js the slider and the choices
"""
