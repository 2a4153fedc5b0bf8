# SPDX-License-Identifier: GPL-3.0-or-later
"""A small runner: speaks the pipe protocol to a subject as the gauge does, one reply a request."""
import base64
import json
import select
import subprocess

PATIENCE = 60  # seconds until a reply is taken for lost


class Talk:
    """One subject process. Use it in a `with`."""

    def __init__(self, command):
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, bufsize=0)
        self.rest = b""
        self.seq = 0

    def __enter__(self):
        return self

    def __exit__(self, *_):
        # In order first, so that the subject can remove its temporary files.
        self.process.stdin.close()
        try:
            self.process.wait(timeout=5)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        for stream in (self.process.stdin, self.process.stdout, self.process.stderr):
            stream.close()

    def write(self, line):
        self.process.stdin.write(line if isinstance(line, bytes) else line.encode("utf-8"))

    def send(self, message):
        self.write(json.dumps(message, ensure_ascii=False) + "\n")

    def line(self):
        """The next line of the subject, as text."""
        while b"\n" not in self.rest:
            if not select.select([self.process.stdout], [], [], PATIENCE)[0]:
                raise TimeoutError("no reply")
            chunk = self.process.stdout.read(1 << 16)
            if not chunk:
                raise EOFError(self.process.stderr.read().decode("utf-8", "replace"))
            self.rest += chunk
        line, self.rest = self.rest.split(b"\n", 1)
        return line.decode("utf-8")

    def ask(self, message):
        self.send(message)
        return json.loads(self.line())

    def start(self, dialect="rs274", profile=None):
        """Starts and configures; returns both replies."""
        begun = self.ask({"cmd": "start", "protocol": [1], "runner": "gonogo 0.0.0"})
        return begun, self.configure(dialect, profile or {})

    def configure(self, dialect, profile):
        return self.ask({"cmd": "configure", "dialect": dialect, "profile": profile})

    def run(self, program):
        """Runs a text or bytes; returns the last reply with the records of all parts, and the
        number of parts before it."""
        self.seq += 1
        if isinstance(program, bytes):
            program = {"base64": base64.b64encode(program).decode("ascii")}
        self.send({"cmd": "run", "seq": self.seq, "id": "case-%d" % self.seq, "program": program})
        records, parts = [], 0
        while True:
            reply = json.loads(self.line())
            if reply["seq"] != self.seq:
                raise ValueError("reply to %r, asked %d" % (reply["seq"], self.seq))
            records += reply["records"]
            if not reply.get("more"):
                return {**reply, "records": records}, parts
            parts += 1

    def stop(self):
        """Says stop; returns the exit code and what stood on standard error."""
        self.send({"cmd": "stop"})
        output, complaints = self.process.communicate(timeout=PATIENCE)
        if self.rest + output:
            raise ValueError("the subject wrote after stop: %r" % (self.rest + output))
        return self.process.returncode, complaints.decode("utf-8", "replace")
