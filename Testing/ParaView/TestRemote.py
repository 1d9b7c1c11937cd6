# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Views that a server draws, of one and of two ranks, against the same views drawn here. Run by pvpython."""

import os
import re
import shutil
import socket
import subprocess
import unittest

import numpy
import Views
from Views import simple


def free_port():
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        return taken.getsockname()[1]


class RemoteTest(Views.ViewTest):
    def setUp(self):
        super().setUp()
        simple.ResetSession()

    def connect(self, ranks=1):
        """Starts a server and connects to it, with the plugin in both and all views drawn there."""
        port = free_port()
        command = ["pvserver", "--server-port=%d" % port]
        if ranks > 1:
            command = ["mpiexec", "-n", str(ranks), "--oversubscribe", *command]
        server = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                                  env={**os.environ, "VTKOIT_LOG": "1"})
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

    def pictures(self, show, methods=("Automatic", "Off")):
        """What a view has by each method: dict. show: shows a scene in a view."""
        view = self.make_view()
        show(view)
        found = {}
        for method in methods:
            Views.page().Method = method
            found[method] = self.picture(view)
        return found


class TestOneRank(RemoteTest):
    def test_as_built_in(self):
        Views.load_plugin()
        here = self.pictures(self.show_scene)
        stack = self.pictures(self.show_stack)
        self.connect()
        there = self.pictures(self.show_scene)
        for method, picture in here.items():
            difference = abs(there[method] - picture)
            print("%s: scene differs by up to %d in %d pixels" % (method, difference.max(), (difference.max(axis=2) > 0).sum()))
        there_stack = self.pictures(self.show_stack)
        for method, picture in stack.items():
            difference = abs(there_stack[method] - picture)
            print("%s: stack differs by up to %d in %d pixels" % (method, difference.max(), (difference.max(axis=2) > 0).sum()))


if __name__ == "__main__":
    Views.main()
