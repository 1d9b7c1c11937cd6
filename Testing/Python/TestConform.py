# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The command conform: what it calls wrong, its page in a browser, and that its scenes are the suite's."""

import json
import os
import re
import sys
import unittest

import Browser
import Support
from TestErrors import run_here
from vtkoit.conform import document, program
from vtkoit.conform.scenes import SCENES, Stress
from vtkoit.conform.verdict import Verdict
from vtkoit.errors import Error

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def program_missing():
    try:
        program.find()
    except Error as error:
        return str(error)
    return ""


def _line(number, contender, color, alpha=0.0, test="TestA", what="x", picture="", key=0):
    return {"number": number, "contender": contender, "test": test, "what": what, "color": color, "alpha": alpha,
            "allowed_color": 0.01, "allowed_alpha": 0.01, "picture": picture, "key": (test, key)}


class TestVerdict(unittest.TestCase):
    def setUp(self):
        scenes = {1: Stress("one", ("TestA",)), 2: Stress("two", ("TestA", "TestB")), 3: Stress("three", ("TestC",))}
        self.verdict = Verdict(scenes, ["good", "bad"], [
            _line(1, "good", 0.01), _line(1, "bad", 0.25, 0.5), _line(1, "bad", 0.0, what="y", key=1),
            _line(2, "good", 0.0, picture="/p/good"), _line(2, "bad", 1e30, what="z", picture="/p/bad"),
            _line(2, "bad", 0.02, test="TestB"), _line(7, "bad", 1.0),
            {"test": "TestC", "contender": "bad", "problem": "ended by signal 11"}])

    def test_matrix(self):
        head, rows = self.verdict.matrix()
        self.assertEqual(head, ["no.", "scene", "good", "bad"])
        self.assertEqual(rows, [["1", "one", "right", "colour 0.250 (1/2), alpha 0.500 (1/2)"],
                                ["2", "two", "right", "colour not finite (2/2)"]])

    def test_worst(self):
        self.assertEqual(self.verdict.worst("good")[1], [])
        self.assertEqual(self.verdict.worst("bad")[1], [
            ["not finite", "2", "TestA", "z"], ["0.250", "1", "TestA", "x"], ["0.020", "2", "TestB", "x"]])

    def test_shown(self):
        self.assertEqual(self.verdict.shown(1), {})
        self.assertEqual({name: line["picture"] for name, line in self.verdict.shown(2).items()},
                         {"good": "/p/good", "bad": "/p/bad"})

    def test_document(self):
        with self.subTest("page"):
            folder = os.getcwd()
            document.write(folder, self.verdict, {"vtk": "9", "renderer": "soft"}, "vtkoit conform")
            self.addCleanup(os.remove, os.path.join(folder, document.PAGE))
            with open(os.path.join(folder, document.PAGE), encoding="utf-8") as file:
                text = file.read()
            self.assertIn("| 2 | two | right | colour not finite (2/2) |", text)
            self.assertIn("- TestC, `bad`: ended by signal 11", text)


class TestScenes(unittest.TestCase):
    def test_are_those_of_the_documentation(self):
        with open(os.path.join(ROOT, "docs", "stress-tests.md"), encoding="utf-8") as file:
            rows = re.findall(r"^\| (\d+) \| ([^|]*) \| ([^|]*) \|", file.read(), re.MULTILINE)
        self.assertEqual(len(rows), 38)
        # The last two are of properties and props that no pass of VTK knows an order for.
        left_out = {15, 29, 30, 34} | {16, 17, 18, 19, 33} | {37, 38}
        self.assertEqual(set(SCENES), {int(number) for number, _, _ in rows} - left_out)
        for number, title, tests in rows:
            if int(number) in SCENES:
                self.assertEqual(SCENES[int(number)].title, title)
                self.assertLessEqual(set(SCENES[int(number)].tests), set(tests.split(", ")), number)

    def test_each_test_is_for_every_method(self):
        with open(os.path.join(ROOT, "Testing", "Cxx", "CMakeLists.txt"), encoding="utf-8") as file:
            listed = re.search(r"set\(vtkoit_method_tests([^)]*)\)", file.read()).group(1).split()
        for scene in SCENES.values():
            self.assertLessEqual(set(scene.tests), set(listed))


class TestCommand(Support.FolderTest):
    def test_refusals(self):
        for arguments, text in (
                (["--scenes", "99"], "--scenes 99: no such scene; --list tells"),
                (["--methods", "nothing"], "method nothing: unknown; the methods are: vtk-weighted"),
                (["--program", "/none"], "--program /none: no program"),
                (["--program", "/bin/false", "--document", "/none"], "--document /none: there is no such folder")):
            done = run_here(["conform", *arguments], self.folder)
            self.assertEqual((done.returncode, done.stdout), (1, ""), done.stderr)
            self.assertRegex(done.stderr, r"^vtkoit conform: %s.*\n$" % re.escape(text))
        self.assertEqual(os.listdir(self.folder), [])

    def test_a_program_that_crashes(self):
        with open(self.path("crash"), "w", encoding="utf-8") as file:
            file.write("#!/bin/sh\nkill -SEGV $$\n")
        os.chmod(self.path("crash"), 0o755)
        done = run_here(["conform", "--program", "crash", "--scenes", "22", "--methods", "vtk-dual"], self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("TestConvexSphere by vtk-dual: ended by signal 11", done.stdout)

    @unittest.skipIf(program_missing(), program_missing())
    def test_two_scenes(self):
        done = run_here(["conform", "--scenes", "21", "22", "--methods", "vtk-weighted", "abuffer", "-o", "out"],
                        self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"(?m)^21 +colour 0\.\d+ \(\d/\d\).* right +two crossing quads$")
        self.assertRegex(done.stdout, r"(?m)^22 +.*right +a sphere: two layers or none$")
        with open(self.path("out/conform.json"), encoding="utf-8") as file:
            results = json.load(file)["results"]
        self.assertEqual({line["number"] for line in results}, {21, 22})
        if not Browser.missing():
            self.look()

    def look(self):
        from selenium.webdriver.support.ui import Select

        with Browser.page(self.path("out/report.html")) as driver:
            names = [option.text for option in Select(driver.find_element("id", "scene")).options]
            self.assertRegex(names[0], r"^21: two crossing quads \(.*\)$")
            self.assertEqual(len(names), 2)
            self.assertEqual([option.text for option in Select(driver.find_element("id", "left")).options],
                             ["right picture", "vtk-weighted", "abuffer"])
            Select(driver.find_element("id", "left")).select_by_visible_text("abuffer")
            Select(driver.find_element("id", "right")).select_by_visible_text("vtk-weighted")
            self.assertRegex(driver.find_element("id", "right-note").text, r"vtk-weighted: colour off by up to 0\.\d+, wrong")
            self.assertIn("right", driver.find_element("id", "left-note").text)
            self.assertEqual(Browser.complaints(driver), [])
            Browser.screenshot(driver, os.path.join(os.path.dirname(self.folder), "conform.png"))
            self.assertGreater(Support.read_picture(os.path.join(os.path.dirname(self.folder), "conform.png")).std(), 5)


if __name__ == "__main__":
    result = unittest.main(exit=False).result
    if result.skipped:
        print("skipped: %s" % result.skipped[0][1])
    sys.exit(1 if not result.wasSuccessful() else 125 if result.skipped else 0)
