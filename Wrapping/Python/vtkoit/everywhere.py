# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Drawing the translucent props of every renderer of this process."""

from .passes import create, plain_name
from .vtkOIT import vtkOITProcessHook

# Those that vtkOITProcessHook hands to the passes that it makes.
_PROPERTIES = ("MaximumBufferSize", "TransmittanceThreshold")


def install_everywhere(method="auto", respect_depth_peeling=False, log=False, **properties):
    """Draws the translucent props of every renderer that is made from now on, or is in a window that
    is made from now on, by a method of vtkOIT; what the application does with depth peeling does not
    matter. `vtkoit run` does the same to a program without a change in it.

    method: str, one of methods(). respect_depth_peeling: bool, True leaves renderers to VTK whose
    depth peeling is off. log: bool, True prints a line for each renderer on standard error, and
    statistics at the end of the process. properties: as for create(), but only MaximumBufferSize
    (bytes, for each renderer) and TransmittanceThreshold; those left out have their defaults.

    Called again, it changes the method and the properties of all renderers that it has reached.
    Renderers that have a pass by install() keep it. A window that was made before is reached by
    install(window). Raises ValueError, and changes nothing, for an unknown method, property or value.
    """
    values = _values(method, properties)
    vtkOITProcessHook.SetRespectDepthPeeling(respect_depth_peeling)
    vtkOITProcessHook.SetLog(log)
    for name, value in values.items():
        getattr(vtkOITProcessHook, "Set" + name)(value)
    vtkOITProcessHook.Install(method)


def uninstall_everywhere():
    """Gives back every renderer that install_everywhere() has reached. True, or False when it was not
    called."""
    return vtkOITProcessHook.Uninstall()


def _values(method, properties):
    """The values of all of _PROPERTIES, dict of str to number. Raises ValueError in one line."""
    for name in properties:
        if plain_name(name) not in map(plain_name, _PROPERTIES):
            raise ValueError("install_everywhere() cannot set %r; it sets: %s (install() sets all that a method has)"
                             % (name, ", ".join(_PROPERTIES)))
    made = create(method, **properties)
    return {name: getattr(made, "Get" + name)() for name in _PROPERTIES}
