# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The application ParaView, run by paraview --script: with PV_PLUGIN_CONFIG_FILE it has loaded the plugin by itself,
without it is loaded later, as by Tools, Manage Plugins, Load New, and reaches the view that the application has made.
"""

import os
import sys
import traceback

sys.path.insert(0, os.environ["VTKOIT_PARAVIEW_TESTS"])


def check():
    import numpy
    import Views
    from Views import simple

    class Scene(Views.ViewTest):
        def runTest(self):
            view = simple.GetActiveView() or simple.CreateView("RenderView")  # which ParaView has made
            if "PV_PLUGIN_CONFIG_FILE" not in os.environ:
                self.assertIsNone(Views.page())
                self.picture(view)
                Views.load_plugin()
            self.assertIsNotNone(Views.page(), "the plugin is not loaded, or has no page")
            self.assertEqual(Views.page().Method, "Automatic")
            view.OrientationAxesVisibility = 0
            view.UseColorPaletteForBackground = 0
            view.Background = [0, 0, 0]
            self.show_stack(view)
            right = Views.expected([0, 0, 0, 255])[:3]
            for method, is_right in (("Automatic", True), ("Off", False), ("A-buffer", True)):
                Views.page().Method = method
                middle = self.picture(view)[Views.SIZE[1] // 2, Views.SIZE[0] // 2]
                print(method, middle, right)
                self.assertEqual(bool(numpy.allclose(middle, right, atol=1.0)), is_right, method)

    result = Scene().run()
    for _, problem in result.failures + result.errors:
        sys.__stderr__.write(problem)
    return 0 if result.wasSuccessful() else 1


status = 1
try:
    status = check()
except Exception:  # pylint: disable=broad-exception-caught # the application would go on
    traceback.print_exc(file=sys.__stderr__)
sys.__stderr__.flush()
os._exit(status)  # without the questions that an application asks at its end
