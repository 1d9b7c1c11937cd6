# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""python3 -m vtkoit: the command line."""

import sys

from .cli import main

if __name__ == "__main__":
    sys.exit(main("python3 -m vtkoit"))
