# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The page that compare and conform write: complete in one file, and its slider in a browser."""

import html.parser
import json
import os
import re
import shutil
import sys
import unittest

import Browser
import numpy
import Support
from vtkoit.errors import Error
from vtkoit.picture import png_of
from vtkoit.report import page

RED, BLUE, BLACK, GREEN = (200, 0, 0), (0, 0, 200), (0, 0, 0), (0, 160, 0)
NASTY = "</script><b>&\"'${x} $title"


def _plain(color, size=(60, 40)):
    return png_of(numpy.full((size[1], size[0], 3), color, dtype=numpy.uint8))


def _page():
    first = page.Scene("one", [page.Shown("red", _plain(RED), _plain(BLACK), "right"),
                               page.Shown("blue", _plain(BLUE), _plain(GREEN), "wrong"),
                               page.Shown(NASTY, _plain(GREEN), None, NASTY)])
    second = page.Scene("two", [page.Shown("blue", _plain(BLACK), None, ""),
                                page.Shown("red", _plain(GREEN), None, "")])
    return page.Page(NASTY, [NASTY], [first, second], "16 times",
                     [page.Table(NASTY, ["method", NASTY], [["red", "1.0"], [NASTY, "2.0"]])],
                     {"cpu": NASTY})


class _Elements(html.parser.HTMLParser):
    """Elements by name with their attributes, and those that are still open."""

    VOID = {"meta", "input", "img"}

    def __init__(self, text):
        super().__init__()
        self.found, self.open = [], []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        self.found.append((tag, dict(attrs)))
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, tag


class TestFile(unittest.TestCase):
    def setUp(self):
        self.text = page.make(_page())
        self.elements = _Elements(self.text)

    def test_is_one_file_without_a_network(self):
        self.assertNotRegex(re.sub("data:image/png;base64,[^\"]*", "", self.text), r"https?:|//\w+\.|@import|url\(")
        self.assertIn("default-src 'none'", self.text)
        for tag, attributes in self.elements.found:
            self.assertNotIn("src", attributes, tag)
            self.assertNotIn("href", attributes, tag)

    def test_names_cannot_end_an_element(self):
        self.assertEqual(self.elements.open, [])
        self.assertNotIn("b", [tag for tag, _ in self.elements.found])
        data = json.loads(re.search(r'id="data">(.*)</script>', self.text).group(1))
        self.assertEqual(data["scenes"][0]["shown"][2]["method"], NASTY)

    def test_every_control_has_a_label(self):
        labelled = [attributes["for"] for tag, attributes in self.elements.found if tag == "label"]
        controls = [attributes["id"] for tag, attributes in self.elements.found if tag in ("select", "input")]
        self.assertEqual(sorted(labelled), sorted(controls))
        self.assertIn(("html", {"lang": "en"}), self.elements.found)

    def test_a_file_that_cannot_be_written(self):
        with self.assertRaisesRegex(Error, "/none/report.html: cannot be written: No such file"):
            page.write(_page(), "/none/report.html")


@unittest.skipIf(Browser.missing(), Browser.missing())
class TestBrowser(Support.FolderTest):
    """The page is looked at: what color the picture has on both sides of the divider."""

    def pixels(self, driver):
        """The colours of the stage a tenth of it left and right of its middle."""
        path = self.path("shot.png")
        Browser.screenshot(driver, path)
        box = driver.execute_script("const b = document.getElementById('stage').getBoundingClientRect();"
                                    "return [b.left + scrollX, b.top + scrollY, b.width, b.height]")
        picture = Support.read_picture(path)[..., :3]
        row = round(box[1] + box[3] / 2)
        return [tuple(int(c) for c in picture[row, round(box[0] + box[2] * part)]) for part in (0.4, 0.6)]

    def choose(self, driver, name, text):
        from selenium.webdriver.support.ui import Select

        Select(driver.find_element("id", name)).select_by_visible_text(text)

    def test_slider(self):
        from selenium.webdriver.common.action_chains import ActionChains
        from selenium.webdriver.common.keys import Keys

        page.write(_page(), self.path("report.html"))
        with Browser.page(self.path("report.html")) as driver:
            self.assertEqual(driver.title, NASTY)
            self.assertEqual(self.pixels(driver), [RED, BLUE])
            divider = driver.find_element("id", "divider")
            divider.send_keys(Keys.END)
            self.assertEqual(divider.get_attribute("aria-valuetext"), "100 % red, 0 % blue")
            self.assertEqual(self.pixels(driver), [RED, RED])
            divider.send_keys(Keys.HOME)
            self.assertEqual(self.pixels(driver), [BLUE, BLUE])
            stage = driver.find_element("id", "stage")
            ActionChains(driver).move_to_element_with_offset(stage, 0, 0).click_and_hold().move_by_offset(
                int(stage.size["width"] * 0.4), 5).release().perform()
            self.assertEqual(self.pixels(driver), [RED, RED])
            divider.send_keys(Keys.HOME, *[Keys.ARROW_RIGHT] * 50)
            self.choose(driver, "show", "differences")
            self.assertEqual(self.pixels(driver), [BLACK, GREEN])
            self.choose(driver, "show", "pictures")
            self.choose(driver, "scene", "two")
            self.assertEqual(self.pixels(driver), [GREEN, BLACK])  # by the same methods
            self.choose(driver, "right", "red")
            self.assertEqual(self.pixels(driver), [GREEN, GREEN])
            self.assertEqual(Browser.complaints(driver), [])

    def test_compare_in_both_schemes(self):
        Support.write_sphere(self.path("outer.vtp"), 2.0)
        Support.write_sphere(self.path("inner.vtp"), 1.0)
        done = self.vtkoit("compare", "outer.vtp", "inner.vtp", "--opacity", "0.3", "0.6", "--size", "200x160",
                           "--methods", "vtk-weighted", "abuffer")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        brightness = {}
        for scheme in ("light", "dark"):
            with Browser.page(self.path("comparison/report.html"), scheme) as driver:
                names = [option.text for option in driver.find_elements("css selector", "#left option")]
                self.assertEqual(names, ["right picture", "blend", "vtk-weighted", "abuffer"])
                self.choose(driver, "left", "vtk-weighted")
                self.choose(driver, "right", "abuffer")
                left, right = self.pixels(driver)
                self.assertNotEqual(left, (255, 255, 255))
                self.assertIn("vtk-weighted: colours off by up to", driver.find_element("id", "left-note").text)
                rows = driver.find_elements("css selector", "tbody tr")
                self.assertEqual(len(rows), 3)
                self.assertEqual(Browser.complaints(driver), [])
                brightness[scheme] = Support.read_picture(self.path("shot.png"))[5, 5, 0]
                shutil.copy(self.path("shot.png"), os.path.join(os.path.dirname(self.folder), "report-%s.png" % scheme))
        self.assertGreater(brightness["light"], 240)
        self.assertLess(brightness["dark"], 60)


if __name__ == "__main__":
    result = unittest.main(exit=False).result
    if result.skipped:
        print("skipped: %s" % result.skipped[0][1])
    sys.exit(1 if not result.wasSuccessful() else 125 if result.skipped else 0)
