# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""on_screen.py [VARIABLE=VALUE…] COMMAND…: runs a program of ParaView on a screen of Xvfb, with a home folder of its
own.

Status: that of the command; 125 with a line where something is missing.
"""

import os
import shutil
import subprocess
import sys
import tempfile


def main(command):
    variables = {}
    while "=" in command[0]:
        name, value = command.pop(0).split("=", 1)
        variables[name] = value
    for program, package in ((command[0], "paraview or python3-paraview"), ("Xvfb", "xvfb")):
        if not shutil.which(program):
            print("needs %s (Debian: %s)" % (program, package))
            return 125
    ours, theirs = os.pipe()
    # ParaView tries a window first, and closes it: without -noreset the screen would start anew at that.
    with subprocess.Popen(["Xvfb", "-displayfd", str(theirs), "-screen", "0", "1280x960x24", "-noreset"],
                          pass_fds=[theirs], stderr=subprocess.DEVNULL) as screen:
        os.close(theirs)
        try:
            with open(ours, encoding="ascii") as pipe:
                display = ":" + pipe.readline().strip()
            with tempfile.TemporaryDirectory(prefix="paraview-home-") as home:
                # Settings of whoever runs the tests must not matter, nor what the tests leave.
                environment = {**os.environ, "DISPLAY": display, "HOME": home, "XDG_CONFIG_HOME": home,
                               # As root, and on one machine.
                               "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
                               "OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_MCA_btl_vader_single_copy_mechanism": "none"}
                for name in ("PV_PLUGIN_CONFIG_FILE", "PV_PLUGIN_PATH", "VTK_AUTOLOAD_PATH"):
                    environment.pop(name, None)
                environment.update(variables)
                return subprocess.run(command, env=environment, stdin=subprocess.DEVNULL, check=False).returncode
        finally:
            screen.terminate()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
