#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""faulty_subject.py FOLDER FAULT REPLY: a subject for lines in the XY plane that breaks once.

The first process that comes to its reply number REPLY does what FAULT says: garbage, half-line,
swapped, gigabyte, exit. All the others are good, and with the fault `none` every one. FOLDER holds
the process ids, one a line, and the mark that the fault has been.
"""
import os
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "helpers"))
sys.dont_write_bytecode = True
from gonogo_pipe import Server, Subject  # noqa: E402

import json  # noqa: E402


class Lines(Subject):
    name, version = "lines", "1"
    dialects = {"rs274": ["basic"]}
    features = ["blocks"]
    numeric = {"kind": "fixed", "resolution": "0.0001"}
    max_in_flight = 64
    delay = float(os.environ.get("FAULTY_DELAY", "0.001"))

    def run(self, program, emit):
        time.sleep(self.delay)
        for number, line in enumerate(program.decode("ascii").split("\n"), 1):
            words = {word[0]: word[1:] for word in line.split()}
            if words.get("G") == "0":
                emit("rapid", b=number, to={"x": words["X"], "y": words["Y"]})
            elif words.get("G") == "1":
                emit("feed", b=number, to={"x": words["X"], "y": words["Y"]}, f=words["F"])
        return None


class Breaking:
    """Sends replies, and breaks at one of them."""

    def __init__(self, folder, fault, at):
        self.mark, self.fault, self.at = os.path.join(folder, "broken"), fault, at
        self.count, self.held = 0, None

    def is_first(self):
        try:
            os.close(os.open(self.mark, os.O_CREAT | os.O_EXCL))
            return True
        except FileExistsError:
            return False

    def send(self, reply):
        line = json.dumps(reply, separators=(",", ":")).encode("ascii") + b"\n"
        if "outcome" in reply:
            self.count += 1
            if self.fault != "none" and self.count == self.at and self.is_first():
                line = self.broken(line)
            elif self.held is not None:
                line, self.held = line + self.held, None
        os.write(1, line) if len(line) < 1 << 16 else sys.stdout.buffer.write(line)
        sys.stdout.buffer.flush()

    def broken(self, line):
        if self.fault == "garbage":
            return b"\x00\xff garbage {]\n"
        if self.fault == "half-line":
            os.write(1, line[:len(line) // 2])
            os._exit(0)
        if self.fault == "exit":
            os._exit(7)
        if self.fault == "swapped":
            self.held = line
            return b""
        if self.fault == "gigabyte":
            piece = b"a" * (1 << 20)
            os.write(1, b'{"seq":1,"message":"')
            for _ in range(1024):
                sys.stdout.buffer.write(piece)
            return b'"}\n'
        return line


def main():
    folder, fault, at = sys.argv[1], sys.argv[2], int(sys.argv[3])
    with open(os.path.join(folder, "processes"), "a") as processes:
        processes.write("%d\n" % os.getpid())
    breaking = Breaking(folder, fault, at)
    server = Server(Lines(), breaking.send)
    try:
        for line in sys.stdin.buffer:
            if not server.answer(line):
                break
    except BrokenPipeError:
        os._exit(0)  # the runner has gone


main()
