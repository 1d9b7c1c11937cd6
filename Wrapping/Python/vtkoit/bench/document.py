# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The page of the documentation."""


def write(folder, machine, results, store, command):
    raise NotImplementedError
