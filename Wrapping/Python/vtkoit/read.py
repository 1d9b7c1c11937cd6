# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reading files of any format that VTK reads, with one line when that fails."""

import collections
import os
import re

from .child import reading
from .errors import Error, capture, error_code_text, printable
from .readers import STACKS, extension_of, extensions, reader_class

Input = collections.namedtuple("Input", "name data")
Input.__doc__ = """What was read: name (str, for messages) and data (vtkDataObject)."""


def read_all(paths, progress, raw=None, spacing=None):
    """Reads files, list of Input.

    Several pictures of one format (png, tif, ...) become one volume, a file each slice, in the
    order of the numbers in their names; with raw all files do. paths: list of str. raw: RawFormat
    of headerless files, or None. spacing: (x, y, z), float, of volumes, or None for the file's own.
    Raises Error in one line that names the file.
    """
    for path in paths:
        with reading(printable(path)):  # a pipe may never open
            _check_exists(path)
    inputs = []
    for group in [paths] if raw is not None else _groups(paths):
        with reading(printable(group[0])):
            inputs.append(_read(group, progress) if raw is None else _read_raw(group, raw, progress))
    if spacing is not None:
        for item in inputs:
            if item.data.IsA("vtkImageData"):
                item.data.SetSpacing(*spacing)
    return inputs


def natural_key(text):
    """Sorts slice2 before slice10: list for sorted(key=)."""
    return [(int(part), "") if place % 2 else (-1, part)
            for place, part in enumerate(re.split(r"([0-9]{1,18})", text))]


def _groups(paths):
    """Lists of paths that belong together, in the order of their first."""
    stacks = collections.Counter(extension_of(path) for path in paths)
    groups = {}
    for number, path in enumerate(paths):
        extension = extension_of(path)
        stacked = extension in STACKS and stacks[extension] > 1
        groups.setdefault(extension if stacked else number, []).append(path)
    return [sorted(group, key=natural_key) for group in groups.values()]


def _check_exists(path):
    if not os.path.exists(path):
        raise Error("%s: no such file" % path)
    if os.path.isdir(path):
        return
    try:
        with open(path, "rb") as file:
            if not file.read(1):
                raise Error("%s: the file is empty" % path)
    except OSError as error:
        raise Error("%s: cannot be opened: %s" % (path, error.strerror)) from None


def _read(paths, progress):
    path = paths[0]
    name = printable(os.path.basename(os.path.normpath(path)))
    if len(paths) > 1:
        name += " and %d more" % (len(paths) - 1)
    extension = "dcm" if os.path.isdir(path) else extension_of(path)
    if os.path.isdir(path) and not _has_dicom(path):
        raise Error("%s: a folder; only folders of DICOM slices (.dcm) can be read" % path)
    found = reader_class(extension)
    if found is None:
        what = "no VTK reader for .%s files" % extension if extension else \
            "its name has no extension that tells the format"
        raise Error("%s: %s; known: %s (other raw volumes: --raw)"
                    % (path, what, " ".join(extensions())))
    reader = found()
    with capture() as captured:
        usable = _set_up(reader, paths, os.path.isdir(path))
        if usable:
            progress.watch(reader, "reading " + name)
            reader.Update()
    return Input(name, _result(reader, usable, captured, path, extension))


def _has_dicom(folder):
    return any(extension_of(name) in ("dcm", "dicom") for name in os.listdir(folder))


def _set_up(reader, paths, is_folder):
    """Gives a reader its files and switches on all they hold; False when it refuses the file."""
    if is_folder:
        reader.SetDirectoryName(os.fsencode(paths[0]))
        return True
    if len(paths) > 1:
        reader.SetFileNames(_string_array(paths))
        return True
    extension = extension_of(paths[0])
    if extension == "stl" and not _is_stl(paths[0]):
        return False
    if extension in ("mhd", "mha") and not _has_dimensions(paths[0]):
        return False
    path = os.fsencode(os.path.abspath(paths[0]))  # names of files are bytes, of any encoding
    # Some readers answer so only after they have their file.
    (reader.SetCaseFileName if hasattr(reader, "SetCaseFileName") else reader.SetFileName)(path)
    if hasattr(reader, "CanReadFile") and not reader.CanReadFile(path):
        return False
    if hasattr(reader, "SetAllArrayStatus"):  # Exodus
        reader.UpdateInformation()
        for kind in ("NODAL", "NODAL_TEMPORAL", "ELEM_BLOCK"):
            reader.SetAllArrayStatus(getattr(reader, kind), 1)
        return True
    for switch in ("EnableAllBases", "EnableAllPointArrays", "EnableAllCellArrays"):
        if hasattr(reader, switch):
            reader.UpdateInformation()
            getattr(reader, switch)()
    return True


def _string_array(paths):
    from vtkmodules.vtkCommonCore import vtkStringArray

    names = vtkStringArray()
    for path in paths:
        names.InsertNextValue(os.fsencode(path))
    return names


def _result(reader, usable, captured, path, extension):
    data = reader.GetOutputDataObject(0) if usable else None
    reason = captured.errors(1)
    if usable and reader.GetErrorCode() and not reason:
        reason = error_code_text(reader.GetErrorCode())
    if not usable or reason or data is None:
        reason = reason or captured.summary(1) or "not a valid .%s file" % extension
        raise Error("%s: cannot be read: %s" % (path, reason))
    if not any(leaf.GetNumberOfPoints() for _, leaf in leaves(data) if leaf.IsA("vtkDataSet")) \
            and not data.IsA("vtkHyperTreeGrid"):
        detail = captured.summary(1)
        raise Error("%s: holds no points%s" % (path, " (%s)" % detail if detail else ""))
    for _, leaf in leaves(data):
        # Also false for what is not a number.
        if leaf.IsA("vtkDataSet") and leaf.GetNumberOfPoints() and \
                not all(abs(bound) < 1e30 for bound in leaf.GetBounds()):
            raise Error("%s: cannot be read: it has coordinates beyond all measure" % path)
    return data


def _is_stl(path):
    """Whether a file is STL text, or binary with as many triangles as it says: VTK does not ask."""
    with open(path, "rb") as file:
        head = file.read(84)
    count = int.from_bytes(head[80:84], "little")
    return head.lstrip()[:5].lower() == b"solid" or \
        (len(head) == 84 and os.path.getsize(path) >= 84 + 50 * count)


def _has_dimensions(path):
    """Whether a MetaImage has a number of dimensions that there is: VTK takes any, and counts to it."""
    with open(path, "rb") as file:
        match = re.search(rb"^\s*NDims\s*[=:]\s*(\S*)", file.read(8192), re.MULTILINE)
    return match is None or re.fullmatch(rb"10|[1-9]", match.group(1)) is not None


def leaves(data, name=""):
    """The data sets of a vtkDataObject, list of (name, vtkDataObject): itself unless composite."""
    if not data.IsA("vtkCompositeDataSet"):
        return [(name, data)]
    from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet

    result = []
    iterator = data.NewIterator()
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        leaf = iterator.GetCurrentDataObject()
        label = ""
        if iterator.HasCurrentMetaData() and \
                iterator.GetCurrentMetaData().Has(vtkCompositeDataSet.NAME()):
            label = iterator.GetCurrentMetaData().Get(vtkCompositeDataSet.NAME())
        if leaf is not None:
            result.append((" ".join(part for part in (name, label) if part), leaf))
        iterator.GoToNextItem()
    return result


_TYPES = {"int8": 15, "uint8": 3, "int16": 4, "uint16": 5, "int32": 6, "uint32": 7,
          "float32": 10, "float64": 11}  # VTK's numbers of the scalar types

RawFormat = collections.namedtuple("RawFormat", "width height depth type big_endian")
RawFormat.__doc__ = """The layout of headerless files: width, height, depth in samples (depth 1 for
one slice a file), type (int, VTK's number) and big_endian (bool)."""


def parse_raw(text):
    """RawFormat of a str like 64x64x93:uint16, :big at its end for big-endian. Raises Error."""
    match = re.fullmatch(r"([0-9]{1,9})x([0-9]{1,9})(?:x([0-9]{1,9}))?:(\w+)(?::(big|little))?", text)
    if not match or match.group(4) not in _TYPES or \
            any(int(n) < 1 for n in match.groups()[:3] if n):
        raise Error("--raw %s: give WIDTHxHEIGHT[xDEPTH]:TYPE[:big], TYPE one of %s"
                    % (text, " ".join(_TYPES)))
    width, height, depth, kind, order = match.groups()
    return RawFormat(int(width), int(height), int(depth or 1), _TYPES[kind], order == "big")


def _read_raw(paths, raw, progress):
    from vtkmodules.vtkIOImage import vtkImageReader2

    paths = sorted(paths, key=natural_key)
    depth = max(raw.depth, len(paths))
    if len(paths) > 1 and raw.depth not in (1, len(paths)):
        raise Error("--raw: %d files for a depth of %d; give one file, or one a slice"
                    % (len(paths), raw.depth))
    reader = vtkImageReader2()
    reader.SetDataScalarType(raw.type)
    reader.SetNumberOfScalarComponents(1)
    reader.SetDataByteOrder(0 if raw.big_endian else 1)
    reader.SetFileDimensionality(2 if len(paths) > 1 else 3)
    reader.SetDataExtent(0, raw.width - 1, 0, raw.height - 1, 0, depth - 1)
    reader.FileLowerLeftOn()
    _check_raw_sizes(paths, raw, depth)
    if len(paths) > 1:
        reader.SetFileNames(_string_array(paths))
    else:
        reader.SetFileName(os.fsencode(paths[0]))
    with capture() as captured:
        progress.watch(reader, "reading raw slices")
        reader.Update()
    name = printable(os.path.basename(paths[0]))
    return Input(name, _result(reader, True, captured, paths[0], "raw"))


def _check_raw_sizes(paths, raw, depth):
    from vtkmodules.vtkCommonCore import vtkDataArray

    array = vtkDataArray.CreateDataArray(raw.type)
    slices = 1 if len(paths) > 1 else depth
    expected = raw.width * raw.height * slices * array.GetDataTypeSize()
    for path in paths:
        size = os.path.getsize(path) if not os.path.isdir(path) else 0
        if size < expected:
            raise Error("%s: has %d bytes where --raw asks for %d" % (path, size, expected))
