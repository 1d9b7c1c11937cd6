# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Errors in one line, whoever reports them: this package, VTK, or a library that VTK calls."""

import contextlib
import os
import re
import sys
import tempfile


class Error(Exception):
    """What a user did that cannot work, in one line that says what to do."""


class Captured:
    """What was written to file descriptor 2; text is complete after the with block."""

    def __init__(self):
        self.text = ""

    def lines(self):
        """The messages in it, list of str: each in one line, VTK's decoration removed, no two alike."""
        return list(dict.fromkeys(_messages(self.text)))

    def summary(self, number=2):
        """The first messages joined into one str, empty when there are none."""
        return "; ".join(line.rstrip(".") for line in self.lines()[:number])

    def errors(self, number=2):
        """The first messages that VTK reported as errors, not as warnings, joined into one str."""
        found = dict.fromkeys(line for level, line in _records(self.text) if level == "error")
        return "; ".join(line.rstrip(".") for line in list(found)[:number])


@contextlib.contextmanager
def capture():
    """Keeps everything written to standard error in the with block, C and C++ code included.

    VTK reports errors there and goes on; readers call libraries that print. Yields a Captured.
    """
    captured = Captured()
    sys.stderr.flush()
    saved = os.dup(2)
    with tempfile.TemporaryFile() as file:
        os.dup2(file.fileno(), 2)
        try:
            yield captured
        finally:
            sys.stderr.flush()
            os.dup2(saved, 2)
            os.close(saved)
            file.seek(0)
            captured.text = file.read().decode("utf-8", "replace")


def watch(instance, event):
    """(messages, tag): a list of str that what a vtkObject reports from now on is added to, each in
    one line, instead of being printed; and what RemoveObserver() takes. event: str, ErrorEvent or
    WarningEvent."""
    messages = []

    def add(_object, _event, text):
        messages.extend(_messages(text))

    add.CallDataType = "string0"
    return messages, instance.AddObserver(event, add)


@contextlib.contextmanager
def listen(instance):
    """Keeps what one vtkObject reports in the with block from being printed.

    Yields a function without arguments that returns the messages, list of str, each in one line,
    errors first.
    """
    errors, errors_tag = watch(instance, "ErrorEvent")
    warnings, warnings_tag = watch(instance, "WarningEvent")
    try:
        yield lambda: errors + warnings
    finally:
        instance.RemoveObserver(errors_tag)
        instance.RemoveObserver(warnings_tag)


# "ERROR: In file.cxx, line 12" of VTK's output window and
# "2026-11-23 10:00:00.000 (0.1s) [ABCD] file.cxx:12 ERR| " of its log: the same message twice.
_HEADING = re.compile(r"^(ERROR|Warning|Generic Warning|Debug): In .*, line \d+$")
_LOG = re.compile(r"^\(?[\d.:\s-]*\(\s*[\d.]+s\)\s*\[[^\]]*\].*?\b(ERR|WARN|INFO)\|\s?")
_IS_ERROR = re.compile(r"\berror\b|premature|unexpected end|truncated", re.IGNORECASE)
_COLOR = re.compile(r"\x1b\[[0-9;]*m")
_OBJECT = re.compile(r"^(\(nullptr\):\s*)?(vtk\w+)(\s*\((0x[0-9a-fA-F]+|nil)\)(\s*'[^']*')?)?:\s*")


def _records(text):
    """Yields (level, line): "error" or "warning" of VTK, "other" for what somebody else printed."""
    level = "other"
    for line in _COLOR.sub("", text).splitlines():
        line = line.strip()
        heading = _HEADING.match(line)
        if heading:
            level = "error" if heading.group(1) == "ERROR" else "warning"
            continue
        if not line:
            level = "other"
            continue
        log = _LOG.match(line)
        if log:
            level = "error" if log.group(1) == "ERR" else "warning"
            line = line[log.end():].strip()
        line = " ".join(_OBJECT.sub("", line).split())
        if line:
            # Some of VTK's readers warn of an error and go on with whatever was in memory.
            yield "error" if level == "warning" and _IS_ERROR.search(line) else level, line


def _messages(text):
    return [line for _, line in _records(text)]


# vtkErrorCode from its first value on; that class is not wrapped.
_ERROR_CODES = ["file not found", "the file cannot be opened", "unrecognized file type",
                "premature end of file", "wrong file format", "no file name", "out of disk space"]


def error_code_text(code):
    """What an error code (int) of a VTK reader or writer means, str."""
    if 20000 < code <= 20000 + len(_ERROR_CODES):
        return _ERROR_CODES[code - 20001]
    return os.strerror(code) if 0 < code < 200 else "error %d" % code


def printable(text):
    """A str with bytes that are not of the locale's encoding, which Python keeps as lone surrogates,
    as escapes: \\xff."""
    return re.sub("[\ud800-\udfff]", lambda match: "\\x%02x" % (ord(match.group()) & 0xff), text)


def one_line(error):
    """The text of an exception as one str without line breaks."""
    text = printable(str(error))
    text = "".join(c if c.isprintable() and c != "\ufffd" else " " for c in text)
    text = " ".join(text.split())
    if len(text) > 600:
        text = text[:300] + " ... " + text[-300:]
    return text or type(error).__name__
