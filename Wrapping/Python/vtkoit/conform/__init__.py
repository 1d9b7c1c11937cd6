# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The command conform: scenes with known answers, drawn by any set of translucent passes.

scenes.py    the scenes, by their numbers in docs/stress-tests.md
program.py   runs vtkOITCxxTests, which draws them, for a pass
verdict.py   what is wrong, and its tables
document.py  the page docs/what-vtk-gets-wrong.md
run.py       the command
"""
