# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Views that a server draws, of one and of two ranks, against the same views drawn here. Run by pvpython, a class
in a process: it has no session after a connection."""

import os
import re
import shutil
import socket
import subprocess

import Views
from Views import simple

METHODS = ("Automatic", "A-buffer", "Dual depth peeling", "Off")


def free_port():
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        return taken.getsockname()[1]


def environment():
    """Without what this pvpython, a process of MPI itself, has told its children."""
    own = ("OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "OMPI_MCA_btl_vader_single_copy_mechanism")
    return {name: value for name, value in os.environ.items()
            if name in own or not re.match("OMPI_|PMIX_|ORTE_", name)}


class RemoteTest(Views.ViewTest):
    def connect(self, ranks=1):
        """Starts a server and connects to it, with the plugin in both and all views drawn there."""
        port = free_port()
        command = ["pvserver", "--server-port=%d" % port]
        if ranks > 1:
            command = ["mpiexec", "-n", str(ranks), "--oversubscribe", *command]
        server = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                                  env=environment())
        self.addCleanup(server.stdout.close)
        self.addCleanup(server.wait)
        self.addCleanup(server.terminate)
        for line in server.stdout:
            if re.search("Accepting connection|Waiting for client", line):
                break
        simple.Connect("127.0.0.1", port)
        self.addCleanup(simple.Disconnect)
        Views.load_plugin(remote=True)
        Views.load_plugin()
        settings = simple.GetSettingsProxy("RenderViewSettings")
        settings.RemoteRenderThreshold = 0
        # Nothing is to be lost on the way.
        settings.CompressorConfig = "vtkLZ4Compressor 0 0"

    def pictures(self, show, methods=METHODS, **properties):
        """What a view has by each method: dict. show: shows a scene in a view."""
        view = self.make_view(**properties)
        show(view)
        found = {}
        for method in methods:
            Views.page().Method = method
            found[method] = self.picture(view)
        simple.Delete(view)
        for source in simple.GetSources().values():
            simple.Delete(source)
        return found

    def check_same(self, there, here, steps=0):
        """Dicts of pictures() that differ by up to some steps of 255."""
        for method, picture in here.items():
            difference = abs(there[method] - picture).max(axis=2)
            with self.subTest(method):
                self.assertLessEqual(difference.max(), steps, "in %d pixels" % (difference > steps).sum())
        # Not the same wrong picture.
        self.assertGreater(abs(here["Automatic"] - here["Off"]).max(), 10)


class TestOneRank(RemoteTest):
    """The picture comes as 8 bits of red, green, blue and opacity over black, and is blended over the background
    here: over another colour than black that rounds once more. Where ParaView then smooths edges (FXAA), which ones it
    takes for edges may hang on that step, so it is off there."""

    def test_as_built_in(self):
        Views.load_plugin()
        gray = {"Background": [0.3, 0.3, 0.4], "UseFXAA": 0}
        scenes = [(self.show_scene, {}, 0), (self.show_stack, {}, 0), (self.show_scene, gray, 1)]
        here = [self.pictures(show, **properties) for show, properties, _ in scenes]
        self.connect()
        for (show, properties, steps), pictures in zip(scenes, here):
            with self.subTest(show.__name__, **properties):
                self.check_same(self.pictures(show, **properties), pictures, steps)


class TestTwoRanks(RemoteTest):
    """Each draws its share of the data, and the pictures are composited in order."""

    def test_as_built_in(self):
        if not shutil.which("mpiexec"):
            self.skipTest("needs mpiexec (Debian: mpi-default-bin)")
        Views.load_plugin()
        here = self.pictures(self.show_stack)
        self.connect(ranks=2)
        there = self.pictures(self.show_stack)
        if abs(there["Off"] - here["Off"]).max() > 2:
            self.skipTest("this ParaView draws another picture with two ranks, without vtkOIT")
        self.check_same(there, here, 2)


if __name__ == "__main__":
    Views.main()
