# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The command line as a process: signals, readers that never end, closed and full standard streams."""

import os
import pty
import signal
import subprocess
import time
import unittest

import Support

# VTK's reader counts to the number of dimensions; the comments hide it from a look at the start.
ENDLESS = "ObjectType = Image\n" + 1000 * "Comment = x\n" + "NDims = 99999999999999999999\n" \
    "DimSize = 4 4 4\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n"


def children(pid):
    """The children of a process, list of int."""
    with open("/proc/%d/task/%d/children" % (pid, pid), encoding="ascii") as file:
        return [int(word) for word in file.read().split()]


def is_alive(pid):
    """Whether a process is there and not waiting for its parent to take note of its end."""
    try:
        with open("/proc/%d/stat" % pid, encoding="ascii") as file:
            return file.read().rsplit(")", 1)[1].split()[0] not in "ZX"
    except (FileNotFoundError, ProcessLookupError):
        return False


def wait_until(condition, seconds=20.0):
    end = time.monotonic() + seconds
    while not condition() and time.monotonic() < end:
        time.sleep(0.02)
    return condition()


class EndlessTest(Support.FolderTest):
    def setUp(self):
        super().setUp()
        with open(self.path("endless.mhd"), "w", encoding="ascii") as file:
            file.write(ENDLESS)

    def start(self, *arguments, **keywords):
        """A vtkoit render, and its child when that reads the file."""
        process = subprocess.Popen(
            [Support.program(), "render", "endless.mhd", "-o", "a.png", *arguments], cwd=self.folder,
            env=Support.bare_environment(), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
            **keywords)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.kill)
        self.assertTrue(wait_until(lambda: children(process.pid)))
        child, = children(process.pid)

        def reads():
            with open("/proc/%d/stat" % child, encoding="ascii") as file:
                return int(file.read().rsplit(")", 1)[1].split()[11]) > 30  # user time in 1/100 s

        self.assertTrue(wait_until(reads))
        return process, child


@unittest.skipUnless(os.path.isdir("/proc/self/task"), "needs /proc of Linux")
class TestSignals(EndlessTest):
    def test_child_ends_with_its_parent(self):
        for number, status in ((signal.SIGTERM, 143), (signal.SIGINT, 130), (signal.SIGKILL, -9)):
            with self.subTest(number):
                process, child = self.start()
                process.send_signal(number)
                _, text = process.communicate(timeout=20)
                self.assertEqual(process.returncode, status)
                self.assertEqual(text, "vtkoit render: interrupted\n" if number == signal.SIGINT else "")
                self.assertTrue(wait_until(lambda: not is_alive(child)))  # pylint: disable=W0640

    def test_what_is_ignored_stays_so(self):
        process, child = self.start(
            preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))  # as nohup does
        process.send_signal(signal.SIGHUP)
        time.sleep(0.3)
        self.assertTrue(is_alive(child))
        process.terminate()
        self.assertEqual(process.wait(20), 143)

    def test_a_crash_names_the_file(self):
        process, child = self.start()
        os.kill(child, signal.SIGSEGV)
        _, text = process.communicate(timeout=20)
        self.assertEqual(process.returncode, 1)
        self.assertEqual(text, "vtkoit render: VTK crashed (Segmentation fault); one of the files is corrupt, "
                         "or memory ran out: endless.mhd\n")


class TestReadTimeout(EndlessTest):
    def fails(self, *arguments, text):
        done = self.vtkoit(*arguments)
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertRegex(done.stderr, "^vtkoit [a-z]+: %s\n$" % text)

    LATE = r"%s: cannot be read: reading it took more than 1 s; .*: --read-timeout S"

    def test_endless_readers(self):
        self.fails("render", "endless.mhd", "--read-timeout", "1", "-o", "a.png",
                   text=self.LATE % "endless.mhd")
        self.fails("compare", "endless.mhd", "--read-timeout", "1", text=self.LATE % "endless.mhd")
        self.fails("bench", "--scenes", "endless.mhd", "--no-plots", "--read-timeout", "1",
                   "--methods", "dual", text=self.LATE % "endless.mhd")

    def test_a_header_that_says_so_at_once(self):
        with open(self.path("a.mhd"), "w", encoding="ascii") as file:
            file.write(ENDLESS.replace("Comment = x\n", ""))
        self.fails("render", "a.mhd", "-o", "a.png", text="a.mhd: cannot be read: not a valid .mhd file")

    def test_a_pipe_that_nobody_opens(self):
        os.mkfifo(self.path("pipe.vtp"))
        self.fails("render", "pipe.vtp", "--read-timeout", "1", "-o", "a.png", text=self.LATE % "pipe.vtp")

    def test_reading_alone_counts(self):
        Support.write_volume(self.path("a.vti"), 60)
        for limit in (0.5, 1.0, 2.0, 4.0, 8.0):  # of a loaded machine
            start = time.monotonic()
            done = self.vtkoit("render", "a.vti", "--isosurface", "120", "150", "180", "--read-timeout", str(limit),
                               "--size", "900x900", "--samples", "0", "-o", "a.png")
            if done.returncode == 0:
                break
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertLess(limit, time.monotonic() - start)
        for value in ("0", "1e6"):
            self.assertEqual(self.vtkoit("render", "a.vti", "--read-timeout", value, "--size", "9x9",
                                         "-o", "a.png").returncode, 0)
        for value in ("-1", "nan", "1e7", "soon"):
            self.fails("render", "a.vti", "--read-timeout", value, "-o", "a.png", text="--read-timeout: .*")


class TestStreams(Support.FolderTest):
    def setUp(self):
        super().setUp()
        Support.write_sphere(self.path("a.vtp"))
        self.commands = [
            (["-h"], 0), (["info"], 0), (["render", "a.vtp", "--size", "9x9", "-o", "a.png"], 0),
            (["paint"], 2), (["render", "no.vtp", "-o", "a.png"], 1)]

    def shell(self, arguments, streams, unbuffered=""):
        """Runs vtkoit with the shell's words for its streams: (status, output, errors)."""
        done = subprocess.run(["sh", "-c", '"$0" "$@" ' + streams, Support.program(), *arguments],
                              cwd=self.folder, capture_output=True, text=True, check=False,
                              env={**Support.bare_environment(), "PYTHONUNBUFFERED": unbuffered})
        self.assertNotIn("internal error", done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        return done.returncode, done.stdout, done.stderr

    @unittest.skipUnless(os.path.exists("/dev/full"), "needs /dev/full")
    def test_output_that_cannot_be_written(self):
        for arguments, right in self.commands:
            for streams, reason in ((">/dev/full", "No space left on device"),
                                    (">&- <&-", "Bad file descriptor")):
                with self.subTest(arguments=arguments, streams=streams):
                    status, _, errors = self.shell(arguments, streams)
                    self.assertEqual(status, right or 1)
                    self.assertEqual(len(errors.splitlines()), 1, errors)
                    if not right:
                        self.assertRegex(errors, r"^vtkoit( \w+)?: standard output cannot be written: %s\n$"
                                         % reason)
        self.assertTrue(os.path.exists(self.path("a.png")))  # the work is done all the same
        status, _, errors = self.shell(["info"], ">/dev/full", "1")
        self.assertEqual((status, len(errors.splitlines())), (1, 1))

    def test_errors_that_cannot_be_written(self):
        for arguments, right in self.commands:
            for streams in ("2>&- <&-", "2>/dev/full"):
                with self.subTest(arguments=arguments, streams=streams):
                    self.assertEqual(self.shell(arguments, streams)[::2], (right, ""))

    def test_reader_of_the_output_leaves(self):
        for arguments in (["info"], ["bench", "--list"], ["-h"]):
            for unbuffered in ("", "1"):
                _, _, errors = self.shell(arguments, "| true", unbuffered)
                self.assertEqual(errors, "")

    def test_progress_is_taken_away(self):
        ours, theirs = pty.openpty()
        os.mkfifo(self.path("pipe.vtp"))
        process = subprocess.Popen(
            [Support.program(), "render", "pipe.vtp", "--read-timeout", "1", "-o", "a.png"],
            cwd=self.folder, env=Support.bare_environment(), stderr=theirs)
        os.close(theirs)
        self.assertEqual(process.wait(30), 1)
        self.assertTrue(os.read(ours, 4096).startswith(b"\r\x1b[Kvtkoit render: "))
        os.close(ours)


class TestNames(Support.FolderTest):
    """Names of files are bytes, of which some are no text."""

    def setUp(self):
        super().setUp()
        self.name = os.fsdecode(b"a\xff\xe4.vtp")
        Support.write_sphere(self.path("a.vtp"))
        os.rename(self.path("a.vtp"), self.path(self.name))

    def run_there(self, *arguments, status=0, **variables):
        done = Support.run(*arguments, cwd=self.folder, **variables)
        self.assertEqual(done.returncode, status, done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1 if status else 0)
        self.assertNotIn("internal error", done.stderr)
        return done.stderr if status else done.stdout

    def test_names_that_are_no_text(self):
        picture = os.fsdecode(b"\xfe.png")
        out = self.run_there("render", self.name, "--size", "20x20", "-o", picture)
        self.assertIn("\\xfe.png: 20x20, 1 surface,", out)
        self.assertTrue(os.path.exists(self.path(picture)))
        for locale in ({"LC_ALL": "C"}, {"LC_ALL": "POSIX", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}):
            self.run_there("render", self.name, "--size", "20x20", "-o", picture, **locale)
        out = self.run_there("compare", self.name, "--size", "9x9", "--methods", "dual", "-o",
                             os.fsdecode(b"\xfd"))
        self.assertIn("a\\xff\\xe4.vtp: 1 surface", out)
        self.assertTrue(os.path.exists(self.path(os.fsdecode(b"\xfd/dual.png"))))
        out = self.run_there("bench", "--scenes", self.name, "--size", "9x9", "--methods", "dual", "--frames",
                             "1", "--no-plots")
        self.assertIn("a\\xff\\xe4.vtp: the file", out)

    def test_slices(self):
        for number in range(3):
            with open(self.path(os.fsdecode(b"\xff%d.raw" % number)), "wb") as file:
                file.write(bytes([0, 0, 0, 0, 200, 0, 0, 0, 0]))
        names = [os.fsdecode(b"\xff%d.raw" % number) for number in range(3)]
        self.run_there("render", *names, "--raw", "3x3:uint8", "--isosurface", "100", "-o", "a.png")

    def test_errors_about_them(self):
        missing = os.fsdecode(b"\xfc.vtp")
        self.assertIn("\\xfc.vtp: no such file", self.run_there("render", missing, "-o", "a.png", status=1))
        for option in ("--contour", "--scalars", "--color", "--camera", "--background", "--set", "--method"):
            text = self.run_there("render", self.name, option, os.fsdecode(b"\xfb"), "-o", "a.png", status=1)
            self.assertIn("%s \\xfb: is not text" % option, text)

    def test_digits_that_are_no_numbers(self):
        for name in ("a\xb2b.vtp", "a\u0663.vtp", "9" * 100 + ".vtp"):
            Support.write_sphere(self.path(name))
            self.run_there("render", name, "--size", "9x9", "-o", "a.png")


if __name__ == "__main__":
    unittest.main()
