# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The methods by name, and the properties of their passes by name."""

import collections
import math

from .errors import listen, one_line
from .vtkOIT import vtkOITPassFactory

MethodInfo = collections.namedtuple("MethodInfo", "name class_name missing")
MethodInfo.__doc__ = """A method: name (str, what install() takes), class_name (str), and missing
(str): empty when it runs in the context asked about, otherwise one line that says what is missing."""


def methods():
    """The names of all methods, list of str."""
    number = vtkOITPassFactory.GetNumberOfMethods()
    return [vtkOITPassFactory.GetMethodName(i) for i in range(number)]


def create(method="auto", **values):
    """A new pass (vtkOITPass) for a method's name, with the given properties.

    It goes where VTK's translucent passes go: vtkRenderStepsPass.SetTranslucentPass(), or a
    vtkSequencePass behind a vtkOpaquePass. Raises ValueError for an unknown method, property or
    value, in one line that lists the valid ones.
    """
    new_pass = vtkOITPassFactory.CreatePass(str(method))
    if new_pass is None:
        raise ValueError(
            "unknown method %r; the methods are: %s" % (method, ", ".join(methods())))
    for name, value in values.items():
        set_property(new_pass, name, value)
    return new_pass


def method_info(window=None):
    """Which methods run in a window's OpenGL context, list of MethodInfo.

    window: a vtkRenderWindow that was rendered at least once; None for a new window of the kind
    that this process makes.
    """
    if window is None:
        from .windows import make_window

        window = make_window(None, (8, 8))
    if window.GetNeverRendered():
        window.Render()
    result = []
    for name in methods():
        instance = create(name)
        missing = one_line_or_empty(instance.GetMissingCapability(window))
        result.append(MethodInfo(name, instance.GetClassName(), missing))
        instance.ReleaseGraphicsResources(window)
    return result


def one_line_or_empty(text):
    """A str without line breaks."""
    return " ".join(text.split())


def properties(method="auto"):
    """The properties of a method with their default values, dict of str to value.

    A property with named values maps to the name of its default, e.g. "half". Those that are other passes
    (VolumetricPass) are left out.
    """
    instance = create(method)
    return {name: _read(instance, name) for name in _property_names(instance) if _is_value(instance, name)}


def set_property(instance, name, value):
    """Sets one property of a pass by name.

    name: str as in C++ without Set (MaximumBufferSize); case and underscores do not matter, so
    maximum_buffer_size is the same. value: what the C++ setter takes, or one of the property's
    named values as str ("float" for FragmentPrecision). Raises ValueError in one line.
    """
    names = _property_names(instance)
    found = [candidate for candidate in names if plain_name(candidate) == plain_name(name)]
    if not found:
        raise ValueError("%s has no property %r; it has: %s"
                         % (instance.GetClassName(), name,
                            ", ".join(name for name in names if _is_value(instance, name))))
    _write(instance, found[0], value)


def plain_name(name):
    """What names of properties, and of their values, are compared by."""
    return str(name).replace("_", "").lower()


def _property_names(instance):
    """Names of what can be set and read on a pass, beyond what every VTK render pass has."""
    from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLRenderPass

    inherited = set(dir(vtkOpenGLRenderPass))
    return sorted(name[3:] for name in dir(instance)
                  if name.startswith("Set") and name not in inherited
                  and hasattr(instance, "Get" + name[3:]))


def _is_value(instance, name):
    """Whether a property is a number or a name, not an object."""
    return isinstance(getattr(instance, "Get" + name)(), (int, float, str))


def _named_values(instance, name):
    """The named values of a property, dict of lower-case str to int; empty for most."""
    owner = type(instance)
    enumeration = getattr(owner, name + "Type", None)
    if not isinstance(enumeration, type):
        return {}
    return {constant.lower(): int(getattr(owner, constant)) for constant in dir(owner)
            if isinstance(getattr(owner, constant), enumeration)}


def _read(instance, name):
    value = getattr(instance, "Get" + name)()
    for text, number in _named_values(instance, name).items():
        if number == value:
            return text
    return value


def _write(instance, name, value):
    named = _named_values(instance, name)
    number = _number(name, value, named) if isinstance(value, str) else value
    if isinstance(number, float) and not math.isfinite(number):
        raise ValueError(_refusal(name, value, "give a finite number"))
    before = getattr(instance, "Get" + name)()
    if isinstance(before, int) and isinstance(number, float) and number.is_integer():
        number = int(number)
    with listen(instance) as messages:
        try:
            getattr(instance, "Set" + name)(number)
        except OverflowError:
            raise ValueError(_refusal(name, value, "give a smaller number")) from None
        except (TypeError, ValueError) as error:
            raise ValueError(_refusal(name, value, one_line(error))) from None
        # Some setters refuse and say so, others clamp in silence; a value that was not asked for is
        # worse than an error.
        after = getattr(instance, "Get" + name)()
        if after == number:
            return
        told = messages()
        getattr(instance, "Set" + name)(before)
    if told:
        raise ValueError(told[0])
    nearest = "the nearest valid value is %r" % after if after != before else "it stays %r" % before
    raise ValueError(_refusal(name, value, nearest + _choices(named)))


def _number(name, text, named):
    """The int or float that a str says: a number, or one of the named values (dict of str to int)."""
    numbers = {plain_name(key): number for key, number in named.items()}
    if plain_name(text) in numbers:
        return numbers[plain_name(text)]
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    raise ValueError(_refusal(name, text, "give one of %s" % ", ".join(sorted(named)) if named
                              else "give a number"))


def _refusal(name, value, what):
    return "%s=%r is refused; %s" % (name, value, what)


def _choices(named):
    return " (%s)" % ", ".join(sorted(named)) if named else ""
