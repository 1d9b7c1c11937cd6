# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The options of the command line, and its help."""

import argparse
import re

from .errors import Error, one_line, printable
from .streams import complain
from .version import PYTHON_VERSION, VERSION, VTK_VERSION, WINDOWS

_MAIN = """examples:
  {prog} info
  {prog} render skull.stl -o skull.png
  {prog} render head.mhd --isosurface 500 1150 --opacity 0.3 0.9 -o head.png
  {prog} compare head.mhd --isosurface 500 1150 --opacity 0.3 0.9 -o comparison
  {prog} showcase -o pictures
  {prog} bench --quick -o numbers"""

_RENDER = """Volumes and grids give isosurfaces (--isosurface) or label surfaces (--labels), surfaces are drawn
as they are. Without either option a volume of few whole numbers is drawn by labels, any other by two
isovalues, which are printed. With --volume they are drawn as volumes, and the surfaces that are asked for stand
among them in the right order. Several pictures (png, tif, ...) of one format make one volume.

examples:
  {prog} ironProt.vtk --isosurface 40 80 120 --opacity 0.2 -o protein.png
  {prog} frog.mhd --labels --smooth 30 --background transparent -o frog.png
  {prog} disk.ex2 --isosurface 400 600 --contour Temp --scalars Pres --colormap coolwarm -o disk.png
  {prog} slices/*.tif --spacing 0.5,0.5,2 --isosurface 100 --camera -y -o scan.png
  {prog} quarter.* --raw 64x64:uint16 --spacing 3.2,3.2,1.5 -o head.png
  {prog} head.mhd --volume --isosurface 1150 --opacity-function 500:0 1150:0.05 -o bone.png
  {prog} outer.stl inner.stl --color steelblue tomato --opacity 0.3 1 --size 1600x1200 -o parts.png
  {prog} skull.stl --opacity 0.4 --method dual:TransmittanceThreshold=0 -o skull.png"""

_COMPARE = """Draws the same as the command render by every method, VTK's own too, and tells what a frame costs and
how far its colours and its alpha are from the right ones, which are computed in double precision from
all fragments. DIR receives report.html, one page with any two pictures under a slider, METHOD.png,
METHOD-difference.png, compare.csv and compare.json.

examples:
  {prog} ironProt.vtk --isosurface 40 80 120 --opacity 0.2 -o protein
  {prog} skull.stl --opacity 0.4 --methods vtk-weighted vtk-dual-4 abuffer --size 1200x900"""

_INFO = """Prints the versions, the class of the render window, the OpenGL context with the extensions that
matter here, and for each method whether it runs and, if not, what is missing.

example:
  {prog}"""

_SHOWCASE = """Draws procedural scenes three ways: VTK's default translucency, VTK's dual depth peeling until it
is done, and vtkOIT. Prints the files, the time per frame, and the error of the colours (0 to 255) against
the right ones, which are computed in double precision from all fragments.

example:
  {prog} -o pictures"""

_BENCH = """Renders scenes by VTK's methods and ours, in turns and in one process, and tells what a frame costs and
how far its colours and its alpha are from the right ones, which are computed in double precision from
all fragments. DIR receives bench.csv, bench.json and pictures: time against error, cost growing with
layers, triangles and pixels, and for each scene image and difference of each method.

A run that was interrupted goes on when it is started again with the same DIR; what was measured with
another build, size or number of frames is measured again.

examples:
  {prog} --quick -o numbers
  {prog} --scenes spheres isosurfaces layers --methods vtk-dual abuffer multilayer:NumberOfLayersPerPass=16
  {prog} --scenes skull.stl layers-* --size 1024x768 -o numbers
  {prog} --list"""

_CONFORM = """Draws the scenes of the stress suite, whose right pictures are known, by VTK's passes and by methods of
vtkOIT, and tells which are wrong, and by how much. DIR receives report.html, one page with any two
pictures of a scene under a slider and the table of all scenes, and conform.json. It needs vtkOITCxxTests,
which is built with the tests; all of it takes some minutes.

examples:
  {prog} -o conformance
  {prog} --scenes 2 5 8 21 --methods vtk-weighted vtk-dual auto
  {prog} --list"""


_RUN = """Runs a program whose renderers are VTK's so that vtkOIT draws what is translucent; nothing in the
program is changed. What is known of a program is used: --preload for f3d, --respect for paraview and
its servers. Where vtkOIT cannot draw, such as with another VTK, a line says why and the program runs
as without it.

examples:
  {prog} mayavi2
  {prog} python3 script.py
  {prog} --method dual --log f3d engine.vtp"""

_METHODS = "names, with properties as METHOD:NAME=VALUE,NAME=VALUE"


class _Parser(argparse.ArgumentParser):
    """Errors in one line, and numbers such as -1e-3 or -1,0,0 are arguments, not options."""

    def __init__(self, *arguments, **keywords):
        super().__init__(*arguments, formatter_class=argparse.RawDescriptionHelpFormatter,
                         allow_abbrev=False, **keywords)
        self._negative_number_matcher = re.compile(r"^-[\d.]")

    def error(self, message):
        complain("%s: %s (see %s -h)\n" % (self.prog, one_line(message), self.prog))
        raise SystemExit(2)


def parser(prog="vtkoit"):
    """The argparse parser of the whole command line."""
    top = _Parser(prog=prog, description="Exact order-independent transparency for VTK data.",
                  epilog=_MAIN.format(prog=prog))
    top.add_argument("--version", action="version", help="show the version and what it was built for",
                     version="vtkOIT %s\nbuilt for VTK %s, Python %s; windows: %s" % (
                         VERSION, VTK_VERSION, PYTHON_VERSION, WINDOWS or "unknown"))
    commands = top.add_subparsers(dest="command", metavar="COMMAND", required=True)

    def add(name, text, epilog):
        return commands.add_parser(name, help=text, description=text[0].upper() + text[1:] + ".",
                                   epilog=epilog.format(prog="%s %s" % (prog, name)))

    _add_render(add("render", "draw data files to a picture", _RENDER))
    _add_compare(add("compare", "draw data files by every method, and tell the errors", _COMPARE))
    _add_conform(add("conform", "draw scenes with known answers by any passes, VTK's too", _CONFORM))
    add("info", "tell what this machine renders with", _INFO)
    showcase = add("showcase", "draw scenes with VTK's methods and ours, and compare", _SHOWCASE)
    showcase.add_argument("-o", "--output", default="showcase", metavar="DIR",
                          help="folder of the pictures, made if missing (default: %(default)s)")
    showcase.add_argument("--size", default="500x500", metavar="WxH",
                          help="size of each picture in pixels (default: %(default)s)")
    _add_run(add("run", "run a VTK application with exact translucency", _RUN))
    _add_bench(add("bench", "measure time and error of all methods, VTK's too", _BENCH))
    return top


def _add_run(run):
    option = run.add_argument
    option("--method", metavar="M", help="see the command info (default: auto)")
    option("--respect", action="store_true", help="leave renderers to VTK whose depth peeling is off")
    option("--log", action="store_true",
           help="print a line for each renderer that is reached, and statistics at the end")
    option("--preload", action=argparse.BooleanOptionalAction,
           help="replace VTK's translucent passes where the program makes them, for programs with a "
                "private chain of passes (default: where the program is known to need it)")
    option("program", nargs=argparse.REMAINDER, metavar="COMMAND", help="the program and its arguments")


def _add_bench(bench):
    option = bench.add_argument
    option("-o", "--output", default="bench", metavar="DIR",
           help="folder of the results, made if missing (default: %(default)s)")
    option("--scenes", nargs="+", metavar="S",
           help="names, patterns such as layers-*, families such as layers, or files (default: all)")
    option("--methods", nargs="+", metavar="M",
           help=_METHODS + " (default: all); blend is always measured, ratios refer to it")
    option("--quick", action="store_true", help="few scenes and methods, small: about a minute")
    option("--size", metavar="WxH", help="pixels (default: 800x800, with --quick 300x300)")
    option("--frames", type=int, metavar="N",
           help="timed frames of a method (default: 15, with --quick 5)")
    option("--budget", type=float, metavar="S",
           help="seconds of timed frames after which a method has fewer (default: 3, with --quick "
                "1)")
    option("--no-plots", action="store_true", help="tables only, without Matplotlib")
    _add_read_timeout(option)
    option("--document", metavar="FOLDER", help=argparse.SUPPRESS)
    # Pages of the documentation instead, for developers: CONTRIBUTING.md tells about them.
    study = bench.add_mutually_exclusive_group()
    option = study.add_argument
    for name in ("--skips", "--costs", "--growth", "--first", "--changes", "--seeds"):
        option(name, action="store_true", help=argparse.SUPPRESS)
    option("--list", action="store_true", help="print all scenes and methods, measure nothing")


def _add_render(render):
    option = render.add_argument
    option("inputs", nargs="+", metavar="INPUT",
           help="a file of any format that VTK reads, told by its extension, or a DICOM folder")
    option("-o", "--output", required=True, metavar="FILE", help="the picture: .png .tif .jpg ...")
    _add_scene(render, "1000x800")
    method = render.add_argument_group("method")
    option = method.add_argument
    option("--samples", type=int, metavar="N",
           help="multisampling for smooth edges, 0 for none (default: 4 for auto and abuffer, "
                "otherwise 0: the other methods cannot)")
    option("--method", default="auto", metavar="M",
           help="see the command info; with properties as METHOD:NAME=VALUE,NAME=VALUE (default: "
                "%(default)s). One that cannot run here is told, and another one draws")
    option("--set", action="append", metavar="NAME=VALUE",
           help="a property of the method, such as FragmentPrecision=float; more of them with commas, "
                "or by --set again")


def _add_scene(render, size):
    """The options about what is drawn, how it looks, and from where; size: str, the default."""
    what = render.add_argument_group("what is drawn")
    option = what.add_argument
    option("--isosurface", nargs="+", metavar="V", help="isovalues of volumes and grids")
    option("--contour", metavar="NAME",
           help="array that --isosurface, --labels or --volume is about (default: the active scalars)")
    option("--labels", nargs="*", metavar="L",
           help="one surface for each label of a label volume; all but 0, or those given")
    option("--smooth", type=int, default=20, metavar="N",
           help="smoothing of label surfaces, iterations, 0 for none (default: %(default)s)")
    option("--volume", action="store_true",
           help="draw image data as volumes; as surfaces, too, where --isosurface or --labels is given")
    option("--raw", metavar="WxH[xD]:TYPE[:big]",
           help="read files without a header, TYPE such as uint16; one file, or one a slice")
    option("--spacing", metavar="X,Y,Z", help="distances between the samples of volumes")
    _add_read_timeout(option)
    look = render.add_argument_group("how it looks")
    option = look.add_argument
    option("--opacity", nargs="+", metavar="A",
           help="from 0 to 1, one a surface in their order, the last one for the rest")
    option("--opacity-function", nargs="+", metavar="V:A",
           help="opacities of a volume's values, linear in between and constant beyond (default: by its "
                "histogram, printed)")
    option("--opacity-length", metavar="L",
           help="length of a path that has these opacities (default: a hundredth of the volume's diagonal)")
    option("--shade", action="store_true", help="light volumes, by their gradients")
    option("--color", nargs="+", metavar="C", help="names, #rrggbb or r,g,b; repeated")
    option("--scalars", metavar="NAME", help="colour the surfaces by this array")
    option("--colormap", default="viridis", metavar="NAME",
           help="of --scalars, isosurfaces and volumes: viridis plasma inferno coolwarm gray rainbow, each also reversed: viridis-r "
                "(default: %(default)s)")
    option("--range", metavar="LOW,HIGH", help="the values at the colour map's two ends (default: all, of "
           "volumes those that are seen)")
    option("--background", default="white", metavar="C",
           help="a colour, or transparent (default: %(default)s)")
    view = render.add_argument_group("view")
    option = view.add_argument
    option("--camera", default="iso", metavar="WHERE",
           help="x -x y -y z -z iso, AZIMUTH,ELEVATION in degrees, a direction X,Y,Z, or nine "
                "numbers: position, focal point, view up (default: %(default)s)")
    option("--up", default="z", metavar="AXIS", help="axis that points up (default: %(default)s)")
    option("--zoom", default="1", metavar="F", help="above 1 for closer (default: %(default)s)")
    option("--parallel", action="store_true", help="parallel instead of perspective projection")
    option("--size", default=size, metavar="WxH", help="pixels (default: %(default)s)")


def _add_read_timeout(option):
    option("--read-timeout", default="600", metavar="S",
           help="seconds after which a file that is still being read is given up, 0 for never "
                "(default: %(default)s)")


def _add_compare(compare):
    option = compare.add_argument
    option("inputs", nargs="+", metavar="INPUT",
           help="a file of any format that VTK reads, told by its extension, or a DICOM folder")
    option("-o", "--output", default="comparison", metavar="DIR",
           help="folder of the pictures and tables, made if missing (default: %(default)s)")
    option("--methods", nargs="+", metavar="M",
           help=_METHODS + " (default: all)")
    _add_scene(compare, "600x480")


def _add_conform(conform):
    option = conform.add_argument
    option("-o", "--output", default="conformance", metavar="DIR",
           help="folder of the page, made if missing (default: %(default)s)")
    option("--scenes", nargs="+", metavar="N", help="numbers of scenes (default: all)")
    option("--methods", nargs="+", metavar="M",
           help="names (default: vtk-weighted vtk-dual vtk-peel abuffer)")
    option("--program", metavar="FILE",
           help="vtkOITCxxTests of a build with tests (default: bin/vtkOITCxxTests of this build)")
    option("--list", action="store_true", help="print all scenes and methods, draw nothing")
    option("--document", metavar="FOLDER", help=argparse.SUPPRESS)


def without_value(arguments):
    """The options that are given as --name=--, of which argparse makes no value up to Python 3.13, and a value or an error of
    its own later; list of str."""
    return [argument for argument in arguments if argument.startswith("--") and argument.endswith("=--")]


def joined(arguments):
    """Joins --camera -x into --camera=-x, which argparse would take for an option, and moves --volume to the end, so that
    files may stand on both its sides; list of str."""
    result = []
    for argument in arguments:
        if result and result[-1] in ("--camera", "--up") and argument[:1] == "-":
            result[-1] += "=" + argument
        else:
            result.append(argument)
    end = result.index("--") if "--" in result else len(result)
    if "--volume" in result[:end]:
        result = [each for each in result[:end] if each != "--volume"] + ["--volume"] + result[end:]
    return result


# What names files, whose names may be any bytes.
_PATHS = ("inputs", "output", "scenes", "document", "program")


def check(options):
    """Raises Error for what no command could use: no value, or bytes that are not of the locale's encoding, but for names
    of files. options: argparse.Namespace."""
    for option in options.without_value:
        raise Error("%s: a value is missing" % option[:-3])
    for name, value in vars(options).items():
        option = "--" + name.replace("_", "-")
        for text in value if isinstance(value, list) else [value]:
            if isinstance(text, str) and name not in _PATHS and printable(text) != text:
                raise Error("%s %s: is not text in the encoding of this terminal"
                            % (option, printable(text)))
