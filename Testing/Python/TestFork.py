# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Drawing in processes that were forked: right, or an error that says why not, and never endless."""

import subprocess
import sys
import unittest

import Support
import vtkoit
from vtkoit.windows import make_window

# Run in a new process: what the tests before this one have drawn must not matter.
START = """
import multiprocessing, os, signal, sys
sys.path.insert(0, %r)
signal.alarm(60)  # an end, if what is tested here has none
import Support, vtkoit
from vtkoit.windows import make_window

def draw(_=None):
    renderer = Support.sphere_renderer()
    vtkoit.install(renderer)
    return int(Support.draw(renderer, (40, 30)).sum())

def in_child(work):
    sys.stdout.flush()
    child = os.fork()
    if child == 0:
        signal.alarm(30)
        work()
        sys.exit(3)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])

""" % sys.path[0]

NO_THREADS = "this process was forked from one that had drawn with OSMesa"


def window_is_ours():
    return make_window(None, (8, 8)).GetClassName() == "vtkOITOSMesaRenderWindow"


class TestFork(Support.FolderTest):
    def python(self, code):
        """(what the code printed, what VTK said)."""
        with open(self.path("script.py"), "w", encoding="ascii") as file:
            file.write(START + code)
        done = subprocess.run([Support.program("vtkoit-python"), self.path("script.py")],
                              env=Support.bare_environment(), capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout, done.stderr

    def test_pool(self):
        for method in ("fork", "forkserver", "spawn"):
            with self.subTest(method):
                out, errors = self.python(
                    "if __name__ == '__main__':\n"
                    "    multiprocessing.set_start_method('%s')\n"
                    "    with multiprocessing.Pool(2) as pool:\n"
                    "        sums = pool.map(draw, range(4))\n"
                    "    print(len(set(sums)), sums[0] == draw())\n" % method)
                self.assertEqual((out, errors), ("1 True\n", ""))

    def test_parent_draws_after_the_fork(self):
        out, errors = self.python(
            "status = in_child(lambda: print(draw()))\nprint(draw(), status)")
        child, parent, status = out.split()
        self.assertEqual((child, status, errors), (parent, "3", ""))

    @unittest.skipUnless(window_is_ours(), "needs the window of vtkOIT, on VTK before 9.4")
    def test_parent_drew_before_the_fork(self):
        out, errors = self.python(
            "before = draw()\nstatus = in_child(draw)\nprint(before == draw(), status)")
        self.assertEqual(out, "True 3\n")
        self.assertIn("no OpenGL context: " + NO_THREADS, errors)
        self.assertIn("set_start_method('spawn')", errors)

    @unittest.skipUnless(window_is_ours(), "needs the window of vtkOIT, on VTK before 9.4")
    def test_window_of_the_parent(self):
        out, errors = self.python(
            "renderer = Support.sphere_renderer()\nvtkoit.install(renderer)\n"
            "window = make_window(renderer, (40, 30))\nwindow.Render()\n"
            "status = in_child(window.Render)\nwindow.Render()\nprint(status)")
        self.assertEqual(out, "3\n")
        self.assertIn("nothing is drawn: " + NO_THREADS, errors)


class TestTrial(unittest.TestCase):
    def test_what_cannot_draw_is_told_at_once(self):
        if vtkoit.backend() != "OSMesa":
            self.skipTest("needs OSMesa")
        done = subprocess.run(
            [Support.program("vtkoit-python"), "-c", "print(3)"], capture_output=True, text=True,
            env={**Support.bare_environment(), "MESA_GL_VERSION_OVERRIDE": "3.1"}, check=False)
        self.assertEqual((done.returncode, done.stdout), (0, "3\n"))
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertRegex(done.stderr, "^vtkoit-python: [^:]*OpenGL 3.2")


if __name__ == "__main__":
    unittest.main()
