# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""One page of HTML that needs no other file and no network: it can be sent to a colleague."""

import base64
import collections
import html
import json
import os
import string

from ..errors import Error

Shown = collections.namedtuple("Shown", "method picture difference note")
Shown.__doc__ = """A picture under the slider: method (str), picture and difference (bytes of PNG files;
difference: None for none), note (str, one line about it)."""

Scene = collections.namedtuple("Scene", "name shown")
Scene.__doc__ = """What is compared: name (str) and shown (list of Shown, of the same size)."""

Table = collections.namedtuple("Table", "caption head rows note")
Table.__doc__ = """caption (str), head (list of str), rows (lists of str), note (str, a paragraph below, empty for
none). The first column names the row."""
Table.__new__.__defaults__ = ("",)

Page = collections.namedtuple("Page", "title lines scenes amplified tables machine")
Page.__doc__ = """title (str), lines (list of str, paragraphs before the pictures), scenes (list of Scene), amplified
(what is done to the differences, str), tables (list of Table), machine (dict, as from
bench.machine.describe())."""

_FOLDER = os.path.dirname(os.path.abspath(__file__))


def write(page, path):
    """Writes a Page to a file, str. Raises Error."""
    try:
        with open(path, "w", encoding="utf-8", errors="replace") as file:
            file.write(make(page))
    except OSError as error:
        raise Error("%s: cannot be written: %s" % (path, error.strerror)) from None


def make(page):
    """The text of a Page, str."""
    # What is put in is not looked at again, whatever is in it.
    return string.Template(_read("page.html")).substitute(
        title=html.escape(page.title),
        lines="\n".join("<p>%s</p>" % html.escape(line) for line in page.lines),
        tables="\n".join(_table(table) for table in page.tables),
        machine="\n".join("<dt>%s</dt><dd>%s</dd>" % (html.escape(str(key)), html.escape(str(value)))
                          for key, value in page.machine.items()),
        style=_read("page.css"), script=_read("page.js"), data=_data(page))


def _read(name):
    with open(os.path.join(_FOLDER, name), encoding="utf-8") as file:
        return file.read()


def _data(page):
    """What the script shows, JSON that cannot end the element that it is in."""
    data = {"amplified": page.amplified, "scenes": [
        {"name": scene.name, "shown": [
            {"method": shown.method, "note": shown.note, "picture": _url(shown.picture),
             "difference": _url(shown.difference)} for shown in scene.shown]}
        for scene in page.scenes]}
    return json.dumps(data).replace("<", "\\u003c")


def _url(png):
    return "data:image/png;base64," + base64.b64encode(png).decode("ascii") if png else None


def _table(table):
    caption = html.escape(table.caption)
    head = "".join('<th scope="col">%s</th>' % html.escape(cell) for cell in table.head)
    rows = []
    for row in table.rows:
        cells = "".join("<td>%s</td>" % html.escape(cell) for cell in row[1:])
        rows.append('<tr><th scope="row">%s</th>%s</tr>' % (html.escape(row[0]), cells))
    return ('<div class="scroll" role="region" tabindex="0" aria-label="%s">\n<table>\n'
            "<caption>%s</caption>\n<thead><tr>%s</tr></thead>\n<tbody>\n%s\n</tbody>\n</table>\n</div>\n%s"
            % (caption, caption, head, "\n".join(rows), table.note and "<p>%s</p>" % html.escape(table.note)))
