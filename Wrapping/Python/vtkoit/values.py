# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Numbers that options give."""

import math
import re

from .errors import Error

LARGEST_SIDE = 16384  # pixels


def parse_size(text):
    """(width, height), int, of a str such as 800x600. Raises Error."""
    match = re.fullmatch(r"([0-9]{1,9})[xX]([0-9]{1,9})", text)
    if match:
        size = (int(match.group(1)), int(match.group(2)))
        if all(1 <= side <= LARGEST_SIDE for side in size):
            return size
    raise Error("--size %s: give WIDTHxHEIGHT, each from 1 to %d, such as 800x600"
                % (text, LARGEST_SIDE))


def parse_numbers(option, texts, low=None, high=None):
    """The floats of a list of str, of which some may hold several with commas. Raises Error."""
    result = []
    for text in ",".join(texts).split(","):
        try:
            value = float(text)
        except ValueError:
            hint = "; input files go before the options" if "." in text or "/" in text else ""
            raise Error("%s: %r is not a number%s" % (option, text, hint)) from None
        if not math.isfinite(value):
            raise Error("%s: %r is not a finite number" % (option, text))
        if low is not None and not low <= value <= high:
            raise Error("%s: %s is not in the range from %.12g to %.12g" % (option, text, low, high))
        result.append(value)
    return result


def parse_whole_numbers(option, texts, low, high):
    """The ints of a list of str, as parse_numbers(). Raises Error."""
    values = parse_numbers(option, texts, low, high)
    for text, value in zip(",".join(texts).split(","), values):
        if not value.is_integer():
            raise Error("%s: %s is not a whole number" % (option, text))
    return [int(value) for value in values]
