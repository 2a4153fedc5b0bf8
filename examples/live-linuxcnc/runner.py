# SPDX-License-Identifier: MIT-0
"""Programs in a running session: each from a defined state, with the samples that it leaves."""
import os
import re
import threading
import time

import hal
import linuxcnc

AXES = "xyzac"
SETTLE = 0.05  # s that are recorded before a program and after it
LINES = 100000  # more than a program has that is run line by line
AT_REST = 4  # looks at the machine that find it idle, one after the other

# The parameters that LinuxCNC keeps from program to program, as at first power-on: no offsets.
KEPT = ([5161 + i for i in range(9)] + [5181 + i for i in range(9)] + [5210 + i for i in range(10)] +
        [5220] + [5221 + 20 * system + i for system in range(9) for i in range(10)])
NEAR = re.compile(r"^Near line (\d+) of\n[^\n]*:\n(.*)", re.DOTALL)


class Samples:
    """What the sampler writes, split by the number of the program that ran."""

    def __init__(self, stream):
        self.by_program = {}
        self.lost = 0
        self.seen = 0  # number of the program of the last line
        self.condition = threading.Condition()
        threading.Thread(target=self._read, args=(stream,), daemon=True).start()

    def _read(self, stream):
        for line in stream:
            cells = line.decode("ascii", "replace").split()
            with self.condition:
                if len(cells) != 11:
                    self.lost += 1  # "overrun"
                    continue
                mark = int(cells.pop())
                self.seen = mark // LINES
                if mark % LINES != 0:
                    cells[8] = str(mark % LINES)
                if self.seen != 0:
                    self.by_program.setdefault(self.seen, []).append(cells)
                else:
                    self.condition.notify_all()

    @staticmethod
    def mark(number, line):
        """Samples from now on are of this program; of this line of it, 0: as the machine says."""
        hal.set_p("sampler.0.pin.9", str(number * LINES + line))

    def take(self, number, timeout=10.0):
        """All samples of a program that is over."""
        with self.condition:
            self.condition.wait_for(lambda: self.seen == 0, timeout)
            return self.by_program.pop(number, [])


class Machine:
    """The session as a user of it sees it."""

    def __init__(self, work, sampler, modes, timeout=30.0):
        self.timeout = timeout
        self.work = work
        self.modes = modes
        self.delays = 0
        self.command = linuxcnc.command()
        self.status = linuxcnc.stat()
        self.errors = linuxcnc.error_channel()
        self.component = hal.component("gonogo-live")
        self.component.ready()
        self.samples = Samples(sampler)
        self._switch_on()

    def _switch_on(self):
        self.command.state(linuxcnc.STATE_ESTOP_RESET)
        self.command.wait_complete(self.timeout)
        self.command.state(linuxcnc.STATE_ON)
        self.command.wait_complete(self.timeout)
        self.command.mode(linuxcnc.MODE_MANUAL)
        self.command.wait_complete(self.timeout)
        self.command.teleop_enable(False)
        self.command.wait_complete(self.timeout)
        self.command.home(-1)
        self._until(lambda: all(self.status.homed[:5]), self.timeout, "the axes are not homed")
        self.command.set_optional_stop(False)
        self.command.set_block_delete(False)
        self.messages()

    def close(self):
        """Lets go of the memory that the session shares, so that it can be removed."""
        self.component.exit()
        self.command = self.status = self.errors = None

    def _until(self, done, timeout, complaint):
        until = time.monotonic() + timeout
        while True:
            self.status.poll()
            if done():
                return
            if time.monotonic() > until:
                raise TimeoutError(complaint)
            time.sleep(0.002)

    def idle(self):
        """The interpreter has nothing more to read, and nothing is queued."""
        status = self.status
        return (status.interp_state == linuxcnc.INTERP_IDLE and status.queue == 0 and
                status.exec_state in (linuxcnc.EXEC_DONE, linuxcnc.EXEC_ERROR) and status.inpos)

    def messages(self):
        """Texts of the error channel since the last time, delays of the servo thread counted apart."""
        texts = []
        while True:
            message = self.errors.poll()
            if not message:
                return texts
            kind, text = message
            if "realtime delay" in text:
                self.delays += 1
            elif kind in (linuxcnc.NML_ERROR, linuxcnc.OPERATOR_ERROR):
                texts.append(text)

    def _mdi(self, words, complaint):
        self.command.mdi(words)
        self.command.wait_complete(self.timeout)
        self._until(self.idle, self.timeout, complaint)

    def _prepare(self, start):
        """Modes, offsets and parameters as at power-on, and the axes at the start."""
        self.command.abort()
        self.command.wait_complete(self.timeout)
        self._until(self.idle, self.timeout, "the machine does not come to rest")
        with open(os.path.join(self.work, "linuxcnc.var"), "w", encoding="ascii") as file:
            for parameter in sorted(KEPT):
                value = 1 if parameter == 5220 else 0
                file.write("%d\t%.6f\n" % (parameter, value))
        self.command.mode(linuxcnc.MODE_MDI)
        self.command.wait_complete(self.timeout)
        self.command.reset_interpreter()
        self.command.wait_complete(self.timeout)
        self._mdi("M5 M9 G17 G21 G40 G49 G54 G80 G90 G94 G97 G98 " + self.modes,
                  "the modes are not set")
        # The interpreter keeps what the last program set.
        self._mdi("G92.1", "the offsets are not taken back")
        for system in range(1, 10):
            self._mdi("G10 L2 P%d X0 Y0 Z0 A0 C0 R0" % system, "the offsets are not taken back")
        # What the program's own header does not lead to its start.
        self._mdi("G0 " + " ".join("%s%s" % (axis.upper(), start.get(axis, "0"))
                                   for axis in AXES), "the axes do not come to their start")
        self.command.mode(linuxcnc.MODE_AUTO)
        self.command.wait_complete(self.timeout)
        self.messages()

    def run(self, number, path, limit, start, by_line):
        """Samples, alarm (text, line) or None, and whether the limit was reached. With `by_line`
        each line is given for itself: nothing is read ahead, so that an alarm finds all motion
        before it done, and does not stop it on the way."""
        self._prepare(start)
        self.command.program_open(path)
        self.command.wait_complete(self.timeout)
        self.samples.mark(number, 0)
        time.sleep(SETTLE)
        over = time.monotonic() + limit
        try:
            alarm, late = (self._lines(number, path, over) if by_line else self._program(over))
            time.sleep(SETTLE)
            alarm = alarm or alarm_of(self.messages())
        finally:
            self.samples.mark(0, 0)
        return self.samples.take(number), alarm, late

    def _taken(self):
        """The last command is taken, if not done."""
        self._until(lambda: self.status.echo_serial_number >= self.command.serial, self.timeout,
                    "a command is not taken")

    def _to_rest(self, over):
        """The first alarm, and whether it took too long."""
        texts = []
        at_rest = 0
        while at_rest < AT_REST:
            self.status.poll()
            texts += self.messages()
            at_rest = at_rest + 1 if self.idle() else 0
            if self.status.interp_state == linuxcnc.INTERP_PAUSED:
                self.command.auto(linuxcnc.AUTO_RESUME)  # an M0
                self._taken()
            if time.monotonic() > over:
                self.command.abort()
                self.command.wait_complete(self.timeout)
                self._until(self.idle, self.timeout, "the machine does not stop")
                return None, True
            time.sleep(0.005)
        return alarm_of(texts), False

    def _program(self, over):
        self.command.auto(linuxcnc.AUTO_RUN, 0)
        self._taken()
        return self._to_rest(over)

    def _lines(self, number, path, over):
        self.command.mode(linuxcnc.MODE_MDI)
        self.command.wait_complete(self.timeout)
        with open(path, encoding="utf-8", errors="replace", newline="") as file:
            lines = re.split("\r\n|\r|\n", file.read())
        for line, text in enumerate(lines, 1):
            if not text.strip():
                continue
            self.samples.mark(number, line)
            self.command.mdi(text)
            self._taken()
            alarm, late = self._to_rest(over)
            if alarm:
                return (alarm[0], line), late
            if late or re.search(r"\bM0*(2|30)\b", text, re.IGNORECASE):
                return None, late
        return None, False


def alarm_of(texts):
    """The first alarm: its text without the place, and the source line (0: not told)."""
    for text in texts:
        near = NEAR.match(text)
        if near:
            return name_of(near.group(2)), int(near.group(1))
    return (name_of(texts[0]), 0) if texts else None


def name_of(text):
    """A text without the numbers that it was filled with."""
    return re.split(r": ?start=", text.strip())[0]
