# SPDX-License-Identifier: MIT-0
"""FreeCAD's Path workbench: its G-code parser and the edges that it makes of the commands.

Lines and arcs come from the edges as they are, helices as chords. It knows no errors and no line
numbers, and its geometry no feeds: F is read off the commands.
"""
import glob
import math
import os
import sys
from fractions import Fraction

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from gonogo_pipe import Subject, alarm, serve  # noqa: E402
from rs274_profile import LOOKED_AT, anything, refusal  # noqa: E402

FOLDERS = ["/usr/lib/freecad-python3/lib", "/usr/share/freecad/Mod/Path", "/usr/share/freecad/Ext"]
CHORD = 0.001
MOTIONS = {"G0", "G00", "G1", "G01", "G2", "G02", "G3", "G03"}


class FreecadPath(Subject):
    name = "freecad-path"
    dialects = {"rs274": ["basic", "arc", "helix"]}
    features = []
    readings = LOOKED_AT
    numeric = {"kind": "binary64", "chord": str(CHORD)}

    def __init__(self):
        sys.path[:0] = [folder for pattern in FOLDERS for folder in glob.glob(pattern)]
        import FreeCAD
        import Part  # noqa: F401  (loads the geometry that PathGeom needs)
        import Path
        import PathScripts.PathGeom as geometry
        self.vector, self.path, self.geometry = FreeCAD.Vector, Path.Path, geometry
        self.version = ".".join(FreeCAD.Version()[:3])

    def configure(self, dialect, profile):
        initial = profile.get("initial", {})
        self.at = [float(Fraction(str(initial.get(axis, 0)))) for axis in "xyz"]
        self.feed = float(Fraction(str(initial.get("f", 0))))
        return refusal(dialect, profile, {"initial." + word: anything for word in "xyzf"})

    def run(self, program, emit):
        path = self.path()
        try:
            path.setFromGCode(program.decode("utf-8", "replace"))
        except Exception as fault:  # FreeCAD's own kind, which cannot be named here
            return alarm(_said(fault))
        at, feed = self.vector(*self.at), self.feed
        for command in path.Commands:
            feed = command.Parameters.get("F", feed)
            if command.Name in ("G4", "G04") and "P" in command.Parameters:
                emit("dwell", s=command.Parameters["P"])
            if command.Name not in MOTIONS:
                continue
            try:
                edge = self.geometry.edgeForCmd(command, at)
            except Exception as fault:
                return alarm(_said(fault))
            if edge is not None:
                _draw(edge, command.Name, at, feed, emit)
            at = self.geometry.commandEndPoint(command, at)
        return None


def _said(fault):
    detail = fault.args[0] if fault.args else fault
    return detail.get("sErrMsg", detail) if isinstance(detail, dict) else detail


def _draw(edge, name, at, feed, emit):
    if not hasattr(edge, "Curve"):
        edge = edge.Edges[0]
    begin, end = (edge.valueAt(value) for value in edge.ParameterRange)
    if (begin - at).Length > 1e-6:
        emit("feed", to=_point(begin), f=feed)  # the drawing has a gap here
    if name in ("G0", "G00"):
        emit("rapid", to=_point(end))
    elif edge.Curve.TypeId == "Part::GeomCircle" and abs(edge.Curve.Axis.z) == 1:
        centre = edge.Curve.Center
        emit("arc", plane="G17", c={"x": centre.x, "y": centre.y},
             rot=int(math.copysign(1, edge.Curve.Axis.z)), to=_point(end), f=feed)
    elif edge.Curve.TypeId == "Part::GeomLine":
        emit("feed", to=_point(end), f=feed)
    else:
        for point in edge.discretize(Deflection=CHORD)[1:]:
            emit("feed", to=_point(point), f=feed)


def _point(point):
    return {"x": point.x, "y": point.y, "z": point.z}


if __name__ == "__main__":
    serve(FreecadPath)
