# SPDX-License-Identifier: MIT-0
"""The GoNoGo pipe protocol, version 1, for a subject written in Python (3.8 or later, no packages).

Copy this file beside your own, derive from `Subject`, and give the class to `serve`:

    from gonogo_pipe import Subject, alarm, serve

    class Acme(Subject):
        name, version = "acme", "3.2.1"
        dialects = {"rs274": ["basic", "arc"]}
        features = ["blocks"]
        numeric = {"kind": "binary64"}

        def run(self, program, emit):
            emit("rapid", b=1, to={"x": 10.0, "y": 0.0})
            return alarm("E61: feed missing", cls="feed-missing", b=2)

    serve(Acme)

`serve` answers start, configure, run, reset and stop. Standard output belongs to the protocol: what
the subject prints, from Python or from a library in C, goes to standard error, also while it is
made (import in `__init__` what prints). An exception in `run` becomes the outcome `error`; the
process lives on. `gonogo certify --subject "pipe:python3 acme.py"`.
"""
import base64
import json
import math
import os
import sys
import traceback
from decimal import Decimal
from fractions import Fraction

PROTOCOL = 1
RECORDS_A_PART = 1000
KINDS = frozenset(["rapid", "feed", "arc", "arc3", "dwell", "thread", "m", "end"])
_INTEGERS = frozenset(["b", "rot", "m"])
_POSITIONS = frozenset(["to", "c", "via"])
_WORDS = frozenset(["k", "plane", "fm", "clause"])


class Subject:
    """What a subject says of itself and does. Derive from it and replace what differs."""

    name = "unnamed"
    version = "0"
    #: {dialect: [feature, ...]}; `gonogo spec --features` prints the vocabulary. None: nothing is
    #: declared, and what run() skips is not claimed.
    dialects = {}
    #: "blocks" (records and alarms carry b), "m" (M functions are records), "bytes" (any bytes as program).
    features = []
    #: Names of the readings that configure() knows; "*" for all. The others are never sent.
    readings = []
    #: kind "fixed", "binary64" or "exact"; resolution, feed_resolution and chord in mm, as text.
    numeric = {"kind": "binary64"}
    #: How many runs the runner may send ahead; they are answered one after the other.
    max_in_flight = 16

    def configure(self, dialect, profile):
        """Takes the profile (a dict, only what differs from the dialect's defaults).

        Returns None, or the sentence that says which key, value or reading is not implemented.
        """
        return "This subject takes no profile but the default." if profile else None

    def run(self, program, emit):
        """Expands `program` (bytes). Every run starts from the configured state.

        Calls emit(kind, key=value, ...) for each record, in order. Returns None when the program
        ran to its end, else what alarm(), skip() or error() made.
        """
        raise NotImplementedError

    def reset(self):
        """Forgets all that earlier programs left behind."""


def alarm(native, cls=None, b=None, word=None):
    """The outcome of a program that the subject rejects.

    `native` is the subject's own number or text; `cls` the class if it is known, else the alarm map
    decides; `b` the source line, 1-based, which a subject with the feature "blocks" has to give.
    """
    fields = {"native": str(native)[:1000], "class": cls, "b": b, "word": word}
    return {"outcome": "alarm", "alarm": {k: v for k, v in fields.items() if v is not None}}


def skip(feature, message=""):
    """The outcome of a program that needs a feature which the subject has not declared."""
    return {"outcome": "skip", "feature": feature, "message": message}


def error(message):
    """The outcome of a program at which the subject itself failed."""
    return {"outcome": "error", "message": str(message)[:1000]}


def number_text(value):
    """`value` as the protocol writes numbers: exactly, for any type. A str is passed on."""
    if isinstance(value, str):
        return value
    if isinstance(value, bool):
        raise TypeError("a truth value is no number")
    if isinstance(value, float):
        if not math.isfinite(value):
            raise ValueError("%r is no number" % value)
        return value.hex()
    if isinstance(value, Decimal) and not value.is_finite():
        raise ValueError("%s is no number" % value)
    if isinstance(value, (int, Decimal, Fraction)):
        return str(value)
    raise TypeError("%s is no number" % type(value).__name__)


def record(kind, fields):
    """The record `kind` with its numbers as text. Fields that are None are left out."""
    if kind not in KINDS:
        raise ValueError("%r is no kind of record" % (kind,))
    line = {"k": kind}
    for key, value in fields.items():
        if value is None:
            continue
        if key in _INTEGERS or key in _WORDS or key.startswith("x-"):
            line[key] = value
        elif isinstance(value, dict) and key in _POSITIONS:
            line[key] = {axis: _number(number) for axis, number in value.items()}
        else:
            line[key] = _number(value)
    return line


def _number(value):
    # {"root": [a, b, c]} and {"enclosure": [low, high]} are numbers too.
    if isinstance(value, dict):
        return {form: [number_text(part) for part in parts] for form, parts in value.items()}
    return number_text(value)


class _Run:
    """The records of one run: sent in parts, so that no program is too long."""

    def __init__(self, seq, write):
        self.seq, self.write, self.records = seq, write, []

    def emit(self, kind, **fields):
        self.records.append(record(kind, fields))
        if len(self.records) >= RECORDS_A_PART:
            self.write({"seq": self.seq, "records": self.records, "more": True})
            self.records = []

    def close(self, outcome):
        self.write({"seq": self.seq, "records": self.records, **outcome})


class Server:
    """Turns messages into replies. `write` takes one reply, a dict."""

    def __init__(self, subject, write):
        self.subject, self.write, self.configured = subject, write, False

    def answer(self, line):
        """Answers one line (bytes). Returns False when it was the last."""
        try:
            message = json.loads(line.decode("utf-8"))
            command = message["cmd"]
        except (ValueError, KeyError, TypeError, RecursionError) as fault:
            self._refuse("The line is no message: %s." % fault)
            return True
        if command == "stop":
            return False
        action = {"start": self._start, "configure": self._configure, "run": self._run,
                  "reset": self._reset}.get(command if isinstance(command, str) else None)
        if action is None:
            self._refuse("There is no command %r." % (command,))
        else:
            action(message)
        return True

    def _refuse(self, text):
        self.write({"ok": False, "message": text[:1000]})

    def _start(self, message):
        offered = message.get("protocol")
        if not isinstance(offered, list) or PROTOCOL not in offered:
            return self._refuse("This subject speaks version %d of the protocol." % PROTOCOL)
        subject = self.subject
        reply = {"protocol": PROTOCOL,
                 "subject": {"name": subject.name, "version": subject.version},
                 "features": subject.features, "readings": subject.readings,
                 "numeric": subject.numeric,
                 "max_in_flight": subject.max_in_flight}
        if subject.dialects is not None:
            reply["dialects"] = subject.dialects
        self.write(reply)

    def _configure(self, message):
        self.configured = False
        try:
            refusal = self.subject.configure(message.get("dialect"), message.get("profile") or {})
        except (Exception, SystemExit) as fault:
            refusal = _told(fault)
        if refusal is not None:
            return self._refuse(refusal)
        self.configured = True
        self.write({"ok": True})

    def _run(self, message):
        run = _Run(message.get("seq"), self.write)
        if not self.configured:
            return run.close(error("A program came before a configuration that was accepted."))
        try:
            outcome = self.subject.run(_bytes_of(message), run.emit)
            run.close(outcome or {"outcome": "ok"})
        except BrokenPipeError:
            raise
        except (Exception, SystemExit) as fault:
            run.close(error(_told(fault)))

    def _reset(self, _message):
        try:
            self.subject.reset()
            self.write({"ok": True})
        except (Exception, SystemExit) as fault:
            self._refuse(_told(fault))


def _bytes_of(message):
    program = message.get("program")
    if isinstance(program, str):
        return program.encode("utf-8")
    if isinstance(program, dict) and isinstance(program.get("base64"), str):
        return base64.b64decode(program["base64"], validate=True)
    raise ValueError('a run needs "program", a text or {"base64": ...}')


def _told(fault):
    traceback.print_exc()
    return "%s: %s" % (type(fault).__name__, fault)


def serve(make):
    """Speaks the protocol on standard input and output until `stop` or the end of the input.

    `make` is called once, without arguments, and returns the Subject: its class will do.
    """
    # File descriptors 0 and 1 are taken away from the subject: a library in C prints to 1 too.
    source, sink = os.fdopen(os.dup(0), "rb"), os.fdopen(os.dup(1), "wb")
    nothing = os.open(os.devnull, os.O_RDONLY)
    os.dup2(nothing, 0)
    os.close(nothing)
    os.dup2(2, 1)
    sys.stdout = sys.stderr

    def write(reply):
        sink.write(json.dumps(reply, separators=(",", ":")).encode("ascii") + b"\n")
        sink.flush()

    server = Server(make(), write)
    try:
        for line in source:
            if line.strip() and not server.answer(line):
                break
    except BrokenPipeError:
        # The runner has gone: what is still buffered goes nowhere, and the subject ends in order.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sink.fileno())
