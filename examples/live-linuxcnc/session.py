# SPDX-License-Identifier: MIT-0
"""One session of LinuxCNC without hardware or display: starts its parts, ends them by their ids."""
import ctypes
import fcntl
import os
import shutil
import signal
import subprocess
import time

BIN = "/usr/bin"
MODULES = "/usr/lib/linuxcnc/modules"
LOCK = "/tmp/gonogo-live-linuxcnc.lock"
# Segments that all sessions of a machine share: HAL, RTAPI, the identity of the session, motion.
SHARED = (0x48414C32, 0x90280A48, 0x48484C34, 100)
PR_SET_CHILD_SUBREAPER = 36
NOBODY = 1000  # as whom the realtime part runs when it is started by root


class SessionFault(Exception):
    """LinuxCNC cannot be run here and now; the text says why."""


def missing():
    """What has to be installed; empty: nothing."""
    needed = ["linuxcncsvr", "milltask", "io", "halcmd", "halsampler", "rtapi_app"]
    gone = [name for name in needed if not os.access(os.path.join(BIN, name), os.X_OK)]
    return "" if not gone else "the package linuxcnc-uspace is not installed (no %s)" % gone[0]


def segments():
    """Shared memory by key: its id and how many processes are attached."""
    found = {}
    with open("/proc/sysvipc/shm", encoding="ascii") as table:
        next(table)
        for row in table:
            cells = row.split()
            found[int(cells[0]) & 0xFFFFFFFF] = (int(cells[1]), int(cells[6]))
    return found


def children(pid):
    """The processes that come from this one, the youngest first."""
    found = []
    for task in os.listdir("/proc/%d/task" % pid):
        try:
            with open("/proc/%d/task/%s/children" % (pid, task), encoding="ascii") as file:
                own = [int(word) for word in file.read().split()]
        except OSError:
            continue
        for child in own:
            try:
                found = children(child) + [child] + found
            except OSError:
                found.append(child)
    return found


class Session:
    """with Session(machine, work): LinuxCNC runs, homed and on; after it nothing is left."""

    def __init__(self, machine, work, timeout=60.0, lag=0.0, modes=""):
        self.machine = machine
        self.work = work
        self.timeout = timeout
        self.lag = lag
        self.modes = modes
        self.lock = None
        self.sampler = None
        self.log = None
        self.environment = None
        # What a part starts and leaves behind becomes a child of this process.
        ctypes.CDLL(None).prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)

    def __enter__(self):
        try:
            self._start()
        except BaseException:
            self._end()
            raise
        return self

    def __exit__(self, *_):
        self._end()

    def _start(self):
        self._take_lock()
        for source in os.listdir(self.machine):
            shutil.copy(os.path.join(self.machine, source), self.work)
        with open(os.path.join(self.work, "gauge.ini"), "a", encoding="ascii") as ini:
            ini.write("RS274NGC_STARTUP_CODE = %s\n" % self.modes)
        self.log = open(os.path.join(self.work, "linuxcnc.log"), "wb")
        realtime = os.path.join(self.work, "realtime")
        os.mkdir(realtime)
        self.environment = dict(os.environ, LANG="C", HAL_RTMOD_DIR=MODULES,
                                RTAPI_FIFO_PATH=os.path.join(realtime, "fifo"))
        if os.geteuid() == 0:
            # Its realtime part does not run as root; what it runs as has to reach its socket.
            self.environment["RTAPI_UID"] = str(NOBODY)
            os.chmod(self.work, 0o711)
            os.chown(realtime, NOBODY, -1)
        os.environ.update(self.environment)
        self._run("linuxcncsvr", "-ini", "gauge.ini")
        self._run("halcmd", "loadusr", "-Wn", "iocontrol", os.path.join(BIN, "io"),
                  "-ini", "gauge.ini")
        for module in ("tpmod", "homemod"):
            self._run("halcmd", "loadrt", module)
        self._run("halcmd", "-i", "gauge.ini", "-f", "gauge.hal")
        if self.lag > 0:
            # A first-order drive: each millisecond it takes this part of what is left of the way.
            for drive in range(5):
                gain = 0.001 / (self.lag + 0.001)
                self._run("halcmd", "setp", "drive.%d.gain" % drive, "%.6f" % gain)
        # It waits for the servo thread to answer, and is ready when that runs.
        task = self._spawn([os.path.join(BIN, "halcmd"), "loadusr", "-Wn", "inihal",
                            os.path.join(BIN, "milltask"), "-ini", "gauge.ini"], stdout=self.log)
        self._run("halcmd", "start")
        try:
            task.wait(self.timeout)
        except subprocess.TimeoutExpired:
            raise SessionFault("milltask does not become ready") from None
        self.sampler = self._spawn(["stdbuf", "-oL", os.path.join(BIN, "halsampler"), "-t"],
                                   stdout=subprocess.PIPE)

    def _take_lock(self):
        self.lock = open(LOCK, "a", encoding="ascii")
        until = time.monotonic() + self.timeout
        while True:
            try:
                fcntl.flock(self.lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
                break
            except BlockingIOError:
                if time.monotonic() > until:
                    raise SessionFault("another live session runs on this machine") from None
                time.sleep(0.2)
        in_use = segments().get(SHARED[0], (0, 0))[1]
        if in_use > 0:
            raise SessionFault("a LinuxCNC runs on this machine (%d processes share its HAL)"
                               % in_use)
        self._drop_segments()

    def _spawn(self, command, **streams):
        return subprocess.Popen(command, cwd=self.work, env=self.environment, stderr=self.log,
                                stdin=subprocess.DEVNULL, start_new_session=True, **streams)

    def _run(self, name, *arguments, check=True):
        part = self._spawn([os.path.join(BIN, name), *arguments], stdout=self.log)
        try:
            code = part.wait(self.timeout)
        except subprocess.TimeoutExpired:
            raise SessionFault("%s %s does not come to an end" % (name, " ".join(arguments))) from None
        if check and code != 0:
            with open(self.log.name, encoding="utf-8", errors="replace") as file:
                said = file.read()[-2000:]
            raise SessionFault("%s %s gave %d:\n%s" % (name, " ".join(arguments), code, said))

    def _end(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, signal.SIG_IGN)
        try:
            if self.environment is not None:
                for command in (("halcmd", "stop"), ("halcmd", "unload", "all"), ("rtapi_app", "exit")):
                    self.timeout = 5.0
                    try:
                        self._run(*command, check=False)
                    except (SessionFault, OSError):
                        pass
        finally:
            self._end_children()
            if self.log is not None:
                self.log.close()
            if self.lock is not None:
                self._drop_segments(own=1)
                self.lock.close()

    @staticmethod
    def _end_children():
        for number, timeout in ((signal.SIGTERM, 3.0), (signal.SIGKILL, 3.0)):
            for pid in children(os.getpid()):
                try:
                    os.kill(pid, number)
                except ProcessLookupError:
                    pass
            until = time.monotonic() + timeout
            while children(os.getpid()) and time.monotonic() < until:
                try:
                    while os.waitpid(-1, os.WNOHANG)[0] != 0:
                        pass
                except ChildProcessError:
                    return
                time.sleep(0.02)

    def _drop_segments(self, own=0):
        """Segments that nobody else is attached to: of this session, or of one that died."""
        keys = list(SHARED)
        with open("/usr/share/linuxcnc/linuxcnc.nml", encoding="utf-8") as table:
            for row in table:
                cells = row.split()
                if len(cells) > 9 and cells[0] == "B" and cells[2] == "SHMEM":
                    keys.append(int(cells[9], 0))
        for key in keys:
            segment, attached = segments().get(key & 0xFFFFFFFF, (None, 1))
            if segment is not None and attached <= own:
                subprocess.run(["ipcrm", "-m", str(segment)], check=False,
                               stderr=subprocess.DEVNULL)
