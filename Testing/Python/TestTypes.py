# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The type stubs: what a type checker says of right and wrong calls, and that they agree with the package."""

import os
import re
import shutil
import subprocess
import sys
import unittest

import Support
import vtkoit

USE = """import vtkoit
from vtkoit.vtkOIT import vtkOITAutoPass, vtkOITPass, vtkOITPassFactory

instance: vtkOITPass = vtkoit.create("abuffer", FragmentPrecision="float")
names: list[str] = vtkoit.methods()
bound: float = instance.GetErrorBound()
exact: bool = instance.GetExact()
instance.SetMaximumBufferSize(2 ** 20)
other: vtkOITPass = vtkOITPassFactory.CreatePass("auto")
version: str = vtkoit.__version__
missing: list[str] = [info.missing for info in vtkoit.method_info()]
WRONG
"""

# A line, and what is said of it.
WRONG = (
    ("vtkoit.create(3)", 'Argument 1 to "create" has incompatible type "int"; expected "str"'),
    ("vtkoit.methods(1)", "Too many arguments"),
    ("vtkoit.nothing()", 'Module has no attribute "nothing"'),
    ("count: int = vtkoit.backend()", "Incompatible types in assignment"),
    ('instance.SetMaximumBufferSize("large")', 'has incompatible type "str"; expected "int"'),
    ("text: str = instance.GetErrorBound()", "Incompatible types in assignment"),
)


@unittest.skipUnless(shutil.which("mypy") and shutil.which("stubtest"), "no mypy and stubtest (Debian: mypy)")
class TestTypes(Support.FolderTest):
    def check(self, *command):
        environment = {**Support.bare_environment(), "MYPYPATH": os.path.dirname(Support.PACKAGE),
                       "PYTHONPATH": os.path.dirname(Support.PACKAGE), "PYTHONDONTWRITEBYTECODE": "1"}
        return subprocess.run(command, cwd=self.folder, env=environment, capture_output=True, text=True,
                              check=False)

    def mypy(self, text):
        with open(self.path("use.py"), "w", encoding="utf-8") as file:
            file.write(text)
        # VTK 9.1 has no stubs of its own.
        return self.check("mypy", "--python-executable", sys.executable, "--ignore-missing-imports",
                          "--follow-imports=silent", "--cache-dir", self.path("cache"), "use.py")

    def test_right_and_wrong_calls(self):
        done = self.mypy(USE.replace("WRONG", ""))
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        done = self.mypy(USE.replace("WRONG", "\n".join(line for line, _ in WRONG)))
        first = USE[:USE.index("WRONG")].count("\n") + 1
        for number, (line, text) in enumerate(WRONG):
            self.assertRegex(done.stdout, r"(?m)^use.py:%d: error: .*%s" % (first + number, re.escape(text)), line)
        self.assertEqual(done.stdout.count("error:"), len(WRONG), done.stdout)

    def test_the_package_and_its_stub_agree(self):
        with open(self.path("mypy.ini"), "w", encoding="utf-8") as file:
            file.write("[mypy]\nignore_missing_imports = True\n")
        done = self.check("stubtest", "--ignore-missing-stub", "--concise", "--mypy-config-file", "mypy.ini", "vtkoit")
        # Static methods of VTK's wrappers are functions of C; submodules without a stub are their own. What is
        # for PyVista is imported where that is. Constructors of VTK 9.6 say that they take anything.
        allowed = re.compile("stub is a staticmethod but|No module named 'pyvista'|__init__ is inconsistent, stub does not have \\*")
        found = [line for line in done.stdout.splitlines()
                 if re.match(r"vtkoit\.(\w+|vtkOIT\w*\..*) ", line) and not allowed.search(line)]
        self.assertEqual(found, [])
        self.assertIn("vtkoit.vtkOIT.vtkOITPass.IsTypeOf is inconsistent", done.stdout)  # it has looked
        with open(os.path.join(Support.PACKAGE, "__init__.pyi"), encoding="utf-8") as file:
            stub = file.read()
        for name in vtkoit.__all__:
            self.assertRegex(stub, r"(?m)^(def |class |from .* as )?%s\b" % name)

    def test_stubs_have_every_wrapped_method(self):
        from vtkoit import vtkOIT

        with open(os.path.join(Support.PACKAGE, "vtkOIT.pyi"), encoding="utf-8") as file:
            stub = file.read()
        for name in ("vtkOITPass", "vtkOITAutoPass", "vtkOITABufferPass", "vtkOITWeightedPass"):
            text = re.search(r"(?ms)^class %s\(.*?(?=^class |\Z)" % name, stub).group()
            for method in vars(getattr(vtkOIT, name)):
                if not method.startswith("_"):
                    self.assertRegex(text, r"(?m)^    (def|class) %s\b|^    %s:" % (method, method))


if __name__ == "__main__":
    result = unittest.main(exit=False).result
    if result.skipped:
        print("skipped: %s" % result.skipped[0][1])
    sys.exit(1 if not result.wasSuccessful() else 125 if result.skipped else 0)
