# SPDX-License-Identifier: MIT-0
"""LinuxCNC's interpreter through its Python module `gcode`, which gives full doubles and lines.

It hands out inches, also where the program has millimetres. They are turned into millimetres exactly, as
fractions, so that no rounding is the adapter's.
"""
import ctypes
import math
import os
import pickle
import sys
import tempfile
from fractions import Fraction

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
import linuxcnc_shared as linuxcnc  # noqa: E402
from gonogo_pipe import Subject, alarm, error, serve, skip  # noqa: E402
from rs274_profile import one_of, refusal  # noqa: E402

MM = linuxcnc.MM
M_PERTURB, ALL_BITS = -6, 0xff  # of glibc: new memory is all zero
NO_TOOL = (-1, *12 * (0.0,), 0)
PLANES = {1: ("G17", "xyz"), 3: ("G18", "zxy"), 2: ("G19", "yzx")}


class Unsupported(Exception):
    """A motion that no record can carry."""


class Canon:
    """The callbacks of one program. `feed` is the one of the profile, in mm/min and degrees/min."""

    def __init__(self, emit, parameter_file, tools, block_delete, feed):
        self.emit, self.tools, self.block_delete = emit, tools, block_delete
        self.parameter_file = parameter_file
        self.line, self.plane, self.per_turn = 0, 1, False
        self.feed = self.rotary_feed = feed
        self.inch, self.at, self.fault = False, (0, 0, 0), None
        self.offsets = {}  # inches and degrees, of six axes
        self.turn = None  # cosine and sine of the angle by which X and Y are turned

    def __getattr__(self, name):
        # The interpreter calls back for spindles, coolant, comments and more: no motion, no record.
        if name.startswith("__"):
            raise AttributeError(name)
        return lambda *_arguments: None

    def next_line(self, state):
        self.line = state.sequence_number
        self.inch = state.units == 200  # G20, in force when the block's F is read

    def comment(self, text):
        # The only word about the feed mode that comes before the motion of the same line.
        if text.startswith("interpreter: feed mode set to "):
            self.per_turn = text.endswith("units per revolution")

    def set_feed_rate(self, feed):
        # In inches, even where it is one of degrees. So under G21 the module has divided the degrees
        # by 25.4.
        if self.line:
            self.feed = Fraction(feed) * MM
            self.rotary_feed = Fraction(feed) if self.inch else self.feed

    def set_plane(self, plane):
        self.plane = plane

    def set_g5x_offset(self, _system, *place):
        self.offsets["system"] = place[:6]

    def set_g92_offset(self, *place):
        self.offsets["g92"] = place[:6]

    def tool_offset(self, *place):
        self.offsets["tool"] = place[:6]

    def set_xy_rotation(self, degrees):
        angle = math.radians(degrees)
        self.turn = (Fraction(math.cos(angle)), Fraction(math.sin(angle))) if angle else None

    def _of_machine(self, place):
        """A place of the program, in mm and degrees of the machine; nothing but a turn rounds."""
        def moved(axis, value, names):
            i = "xyzabc".index(axis)
            return Fraction(value) + sum(Fraction(self.offsets[name][i]) for name in names)
        others = self.offsets.keys() - {"g92"}
        place = {axis: moved(axis, value, self.offsets.keys() & {"g92"})
                 for axis, value in place.items()}
        if self.turn:
            if not {"x", "y"} <= place.keys():
                self._fail(Unsupported("A turned arc out of the plane XY has no place in a record."))
            (cosine, sine), x, y = self.turn, place["x"], place["y"]
            place["x"], place["y"] = x * cosine - y * sine, x * sine + y * cosine
        return {axis: moved(axis, value, others) * (MM if axis in "xyz" else 1)
                for axis, value in place.items()}

    def _feeds(self, turns_only=False):
        return {"f": self.rotary_feed if turns_only else self.feed,
                "fm": "rev" if self.per_turn else None}

    def _put(self, kind, to, others, **fields):
        to = self._of_machine({**to, **dict(zip("abc", others))})
        at, self.at = self.at, (to["x"], to["y"], to["z"])
        if not self.line:
            return  # the way to the profile's initial position
        if to.pop("b") or any(others[3:]):
            self._fail(Unsupported("The axes B, U, V and W have no place in a record."))
        if kind != "rapid":
            # A change of units or offsets leaves the last bits of the place changed.
            turns_only = kind == "feed" and all(abs(new - old) < 1e-10
                                                for new, old in zip(self.at, at))
            fields.update(self._feeds(turns_only))
        self._emit(kind, to=to, **fields)

    def _emit(self, kind, **fields):
        try:
            self.emit(kind, b=self.line, **fields)
        except Exception as fault:
            self._fail(fault)

    def _fail(self, fault):
        # The interpreter stops at an exception, and reports another one in its place.
        self.fault = fault
        raise fault

    def straight_traverse(self, x, y, z, *others):
        self._put("rapid", {"x": x, "y": y, "z": z}, others)

    def straight_feed(self, x, y, z, *others):
        self._put("feed", {"x": x, "y": y, "z": z}, others)

    def arc_feed(self, end1, end2, centre1, centre2, turn, axial, *others):
        plane, (first, second, third) = PLANES[self.plane]
        centre = self._of_machine({first: centre1, second: centre2})
        self._put("arc", {first: end1, second: end2, third: axial}, others, plane=plane,
                  c=centre, rot=turn)

    def rigid_tap(self, *_place):
        self._fail(Unsupported("The module tells nothing of the lead of a thread."))

    def dwell(self, seconds):
        self._emit("dwell", s=seconds)

    def change_tool(self, pocket):
        self.tools[0] = self.tools.get(pocket, NO_TOOL)  # the spindle

    # What the interpreter asks.
    def get_tool(self, pocket):
        return self.tools.get(pocket, NO_TOOL)

    def get_external_length_units(self):
        return 1 / 25.4

    def get_external_angular_units(self):
        return 1.0

    def get_axis_mask(self):
        return 0o777

    def get_block_delete(self):
        return self.block_delete

    def check_abort(self):
        return False


class LinuxcncGcode(Subject):
    name = "linuxcnc-gcode"
    version = linuxcnc.version()
    dialects = {"rs274": linuxcnc.FEATURES}
    features = ["blocks"]  # not "bytes": a comment that is not UTF-8 breaks the module
    readings = linuxcnc.NAMES
    numeric = {"kind": "binary64"}

    def __init__(self):
        import gcode  # only here: the helpers above can be read without LinuxCNC
        self.gcode = gcode
        # The interpreter reads of the spindle what it has never written; in a new program it is zero.
        ctypes.CDLL(None).mallopt(M_PERTURB, ALL_BITS)
        self.folder = tempfile.TemporaryDirectory(prefix="gonogo-linuxcnc-")
        linuxcnc.open_tools(self.folder.name)
        os.chdir(self.folder.name)  # where programs look for subroutines and write their logs

    def configure(self, dialect, profile):
        at = {"initial." + word: _is_plain for word in "xyzacf"}
        refused = refusal(dialect, profile, {
            **linuxcnc.READINGS, **linuxcnc.settable(profile), **at, "units": one_of("mm", "inch"),
            "block_skip": one_of(False, True), "initial.plane": one_of("G17", "G18", "G19"),
        })
        if refused:
            return refused
        initial = dict(profile.get("initial", {}))
        if "offsets" in profile:  # the module begins at the origin of G54
            initial = {**dict.fromkeys("xyzac", 0), **initial}
        axes = "".join(" %s%s" % (axis.upper(), initial[axis])
                       for axis in "xyzac" if axis in initial)
        self.place = "G21" + (" G53 G0" + axes if axes else "")
        self.parameters = linuxcnc.parameters(profile)
        self.tools = linuxcnc.tools(profile)
        linuxcnc.load_tools(self.folder.name, profile)
        self.feed = initial.get("f", 0)  # without an F the module begins with F1
        # G80 forgets the G0 of the way there.
        units = "G20" if profile.get("units") == "inch" else "G21"
        self.modes = "F%s %s %s%s" % (self.feed, units, initial.get("plane", "G17"),
                                      " G80" if axes else "")
        self.block_skip = bool(profile.get("block_skip"))
        return None

    def run(self, program, emit):
        # Each program has a process of its own: a tool length offset outlives its program.
        come, go = os.pipe()
        child = os.fork()
        if child == 0:
            os.close(come)
            with os.fdopen(go, "wb") as parent:
                self._tell(program, parent)
            os._exit(0)
        os.close(go)
        outcome = None
        try:
            with os.fdopen(come, "rb") as told:
                while outcome is None:
                    kind, fields = pickle.load(told)
                    if kind == "outcome":
                        outcome = fields or {"outcome": "ok"}
                    else:
                        emit(kind, **fields)
        except EOFError:
            pass
        finally:
            status = os.waitpid(child, 0)[1]
        return outcome or error("The interpreter's process ended with status %d." % status)

    def _tell(self, program, parent):
        def put(*told):
            pickle.dump(told, parent)

        try:
            put("outcome", self._outcome(program, lambda kind, **fields: put(kind, fields)))
        except BrokenPipeError:
            os._exit(1)
        except Exception as fault:
            put("outcome", error("%s: %s" % (type(fault).__name__, fault)))

    def _outcome(self, program, emit):
        parameter_file = os.path.join(self.folder.name, "rs274ngc.var")
        # What programs leave behind in it would be the next one's start.
        with open(parameter_file, "w", encoding="ascii") as file:
            file.write(self.parameters)
        canon = Canon(emit, parameter_file, dict(self.tools), self.block_skip, Fraction(self.feed))
        try:
            result = self._parse(program, canon, self.place, self.modes)
        except Exception:
            if isinstance(canon.fault, Unsupported):
                return skip("records", str(canon.fault))
            raise canon.fault or sys.exc_info()[1]
        if result <= self.gcode.MIN_ERROR:
            return None
        message = self.gcode.strerror(result)
        # next_line is called for the line at fault too; the number that parse returns is one too
        # high when that line could not be read. It is not called where every line is blank.
        return alarm(message, linuxcnc.class_of(message), b=max(canon.line, 1))

    def _parse(self, program, canon, *start):
        # In the current folder: some messages name the file.
        with open("program.ngc", "wb") as file:
            file.write(program)
        return self.gcode.parse("program.ngc", canon, *start)[0]


def _is_plain(value):
    text = str(value).lstrip("-")
    return text.replace(".", "", 1).isdigit()


if __name__ == "__main__":
    serve(LinuxcncGcode)
