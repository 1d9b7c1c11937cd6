# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""A method with properties as the command line names it: METHOD, or METHOD:NAME=VALUE,NAME=VALUE."""

from .errors import Error
from .passes import create, methods


def joined(method, settings):
    """One str of a method (str, with properties or not) and of those that --set gives it (list of str,
    each NAME=VALUE or several with commas)."""
    if not settings:
        return method
    return "%s%s%s" % (method, "," if ":" in method else ":", ",".join(settings))


def parse(text, others=()):
    """(method, properties) of a str: str, and dict of str to str, in the order given.

    others: names (str) that are methods too, and take no properties: VTK's own. Raises Error for
    what does not exist or is refused.
    """
    method, _, rest = text.partition(":")
    if method not in methods() and method not in others:
        raise Error("method %s: unknown; the methods are: %s"
                    % (text, " ".join(list(others) + methods())))
    properties = {}
    for setting in filter(None, rest.split(",")):
        name, equals, value = setting.partition("=")
        if not name or not equals or not value:
            raise Error("method %s: give METHOD:NAME=VALUE,NAME=VALUE" % text)
        properties[name] = value
    if method in others:
        if properties:
            raise Error("method %s: VTK's methods take no properties here" % text)
        return method, properties
    try:
        create(method, **properties)
    except ValueError as error:
        raise Error("method %s: %s" % (text, error)) from None
    return method, properties
