# SPDX-License-Identifier: MIT-0
"""LinuxCNC's stand-alone interpreter `rs274 -g`: canonical calls as text, with four decimals.

The units of its lengths follow the program's G20 and G21. It gives no line numbers.
"""
import os
import subprocess
import sys
import tempfile
from decimal import Decimal

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
import linuxcnc_shared as linuxcnc  # noqa: E402
from canonical_calls import Calls, Unsupported  # noqa: E402
from gonogo_pipe import Subject, alarm, error, serve, skip  # noqa: E402
from rs274_profile import one_of, refusal  # noqa: E402

class LinuxcncRs274(Subject):
    name = "linuxcnc-rs274"
    version = linuxcnc.version()
    dialects = {"rs274": linuxcnc.FEATURES + linuxcnc.THREADS}
    features = ["bytes", "m"]
    readings = linuxcnc.NAMES
    numeric = {"kind": "fixed", "resolution": "0.0001", "feed_resolution": "0.0001"}

    def __init__(self):
        self.folder = tempfile.TemporaryDirectory(prefix="gonogo-rs274-")

    def configure(self, dialect, profile):
        refused = refusal(dialect, profile, {
            **linuxcnc.READINGS, **linuxcnc.settable(profile), "block_skip": one_of(False, True),
            "resolution": lambda value: Decimal(str(value)) >= Decimal("0.0001"),
        })
        if refused is None:
            self.flags = [*linuxcnc.TOOL_OPTIONS, "-v", "parameters.var",
                          *["-b"] * bool(profile.get("block_skip"))]
            self.parameters = linuxcnc.parameters(profile).encode()
            self._write("tool.tbl", linuxcnc.tool_table(profile).encode())
        return refused

    def run(self, program, emit):
        self._write("program.ngc", program)
        # What a program leaves in the parameters would be the next one's start.
        self._write("parameters.var", self.parameters)
        calls = Calls(emit)
        with tempfile.TemporaryFile() as complaints:
            with subprocess.Popen(["rs274", *self.flags, "-g", "program.ngc"],
                                  cwd=self.folder.name, env=linuxcnc.home(self.folder.name),
                                  stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                  stderr=complaints) as process:
                try:
                    calls.take(line.decode("utf-8", "replace") for line in process.stdout)
                except Unsupported as reason:
                    process.kill()
                    return skip("records", str(reason))
            complaints.seek(0)
            said = complaints.read().decode("utf-8", "replace").splitlines()
        return _outcome(process.returncode, [line for line in said if line != "executing"])

    def _write(self, name, content):
        with open(os.path.join(self.folder.name, name), "wb") as file:
            file.write(content)


def _outcome(code, said):
    if code == 0:
        return None
    if code != 1 or not said:
        return error("rs274 ended with %d: %s" % (code, " | ".join(said)))
    # The message, and then the block that it is about.
    return alarm(said[0], linuxcnc.class_of(said[0]))


if __name__ == "__main__":
    serve(LinuxcncRs274)
