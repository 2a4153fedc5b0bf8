# SPDX-License-Identifier: GPL-3.0-or-later
"""The plugin of pytest: `pytest --gonogo-subject SPEC [--gonogo-dialect NAME ...]` adds a test for each
cycle of the corpus, `gonogo::DIALECT::CYCLE`; with `--gonogo-cases` one for each case, `gonogo::DIALECT::CYCLE::ID`.

A test passes when the answer is GO, is skipped when the subject claims none of its cases, and fails with what
`gonogo certify` says of it and the program of the smallest case. A dialect of which nothing was judged makes
the run fail. A case that is known to fail (--gonogo-known-failures) is an xfail; cycles are run while their cases are
collected. Readings are reconciled within a cycle: a whole `gonogo certify` does so across them."""
import json
import re
import shlex
import subprocess
from pathlib import Path

import pytest

from gonogo import program

# Those of `gonogo certify`, handed on as they are; the true ones may be given several times.
HANDED_ON = {"reading": True, "only": True, "tolerance": False, "chord": False, "profile": False,
             "known-failures": False, "alarm-map": False, "timeout": False}
GO, NO_GO, UNDECIDED = 0, 1, 3


def pytest_addoption(parser):
    group = parser.getgroup("gonogo", "GoNoGo: conformance of CNC canned cycles")
    group.addoption("--gonogo-subject", metavar="SPEC",
                    help="what is judged: pipe:COMMAND, oneshot:COMMAND, lib:./NAME.so, builtin:NAME")
    group.addoption("--gonogo-dialect", metavar="NAME", action="append", default=[],
                    help="only the cycles of this dialect (repeat for more)")
    group.addoption("--gonogo-cycle", metavar="NAME", action="append", default=[],
                    help="only this cycle (repeat for more)")
    group.addoption("--gonogo-corpus", metavar="FOLDER", help="another corpus than that of the program")
    group.addoption("--gonogo-report", metavar="FOLDER", default="gonogo-report",
                    help="folder for the report of each cycle (gonogo-report)")
    group.addoption("--gonogo-program", metavar="FILE", help="another program than that of this package")
    group.addoption("--gonogo-cases", action="store_true", help="a test for each case, not for each cycle")
    for name, repeated in HANDED_ON.items():
        group.addoption(f"--gonogo-{name}", metavar="VALUE", action="append", default=[],
                        help=f"as --{name} of `gonogo certify`" + (" (repeat for more)" if repeated else ""))


def value_of(config, name):
    return config.getoption("gonogo_" + name.replace("-", "_"))


def gauge(config, *words):
    """Runs the program; gives what it did, with both streams as one text."""
    command = [value_of(config, "program") or program(), *words]
    return subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, cwd=str(config.invocation_params.dir), text=True,
                          errors="replace", check=False)


def corpus_words(config):
    corpus = value_of(config, "corpus")
    return ["--corpus", corpus] if corpus else []


def cycles_of(config):
    """(dialect, cycle) of everything that is asked for."""
    words = ["corpus", "cycles", *corpus_words(config)]
    for name in ("dialect", "only"):
        for value in value_of(config, name):
            words += [f"--{name}", value]
    listed = gauge(config, *words)
    if listed.returncode != GO:
        raise pytest.UsageError(listed.stdout.strip())
    cycles = [tuple(line.split()[:2]) for line in listed.stdout.splitlines()]
    wanted = value_of(config, "cycle")
    unknown = set(wanted) - {cycle for _, cycle in cycles}
    if unknown:
        raise pytest.UsageError(f"--gonogo-cycle: there is no cycle {', '.join(sorted(unknown))}.")
    return [one for one in cycles if not wanted or one[1] in wanted]


def pytest_configure(config):
    if value_of(config, "subject"):
        config.pluginmanager.register(Conformance(config), "gonogo-conformance")


class Conformance:
    """A run with a subject."""

    def __init__(self, config):
        for name, repeated in HANDED_ON.items():
            if not repeated and len(value_of(config, name)) > 1:
                raise pytest.UsageError(f"--gonogo-{name} is given once.")
        self.cycles = cycles_of(config)
        self.judged = {}  # dialect to whether anything of it was

    @pytest.hookimpl(hookwrapper=True)
    def pytest_make_collect_report(self, collector):
        """The cycles come beside the files, if any, that pytest collects."""
        outcome = yield
        if isinstance(collector, pytest.Session):
            report = outcome.get_result()
            report.result = [*report.result, Cycles.from_parent(collector, cycles=self.cycles)]

    def pytest_runtest_logreport(self, report):
        facts = dict(report.user_properties)
        if report.when == "call" and "gonogo_dialect" in facts:
            dialect = facts["gonogo_dialect"]
            self.judged[dialect] = self.judged.get(dialect, False) or facts["gonogo_judged"]

    @pytest.hookimpl(tryfirst=True)
    def pytest_sessionfinish(self, session, exitstatus):
        if exitstatus == pytest.ExitCode.OK and not all(self.judged.values()):
            session.exitstatus = pytest.ExitCode.TESTS_FAILED

    def pytest_terminal_summary(self, terminalreporter):
        for dialect in [name for name, any_case in self.judged.items() if not any_case]:
            terminalreporter.write_line(
                f"gonogo: nothing of {dialect} was judged: the subject claims none of it.", red=True)


class Cycles(pytest.Collector):
    """All cycles of a run; there is no file that they come from."""

    def __init__(self, *, cycles, **rest):
        super().__init__(name="gonogo", nodeid="gonogo", **rest)
        self.cycles = cycles

    def collect(self):
        make = CaseTests if value_of(self.config, "cases") else CycleTest
        for dialect, cycle in self.cycles:
            yield make.from_parent(self, name=f"{dialect}::{cycle}", dialect=dialect, cycle=cycle)


class NotGo(Exception):
    """What the program said; `report` is its folder."""

    def __init__(self, output, command, report):
        super().__init__(output)
        self.output, self.command, self.report = output, command, report


class Campaign:
    """A cycle, run by the program; for a test or a collector of tests."""

    def __init__(self, *, dialect, cycle, **rest):
        super().__init__(**rest)
        self.dialect, self.cycle = dialect, cycle

    def certify(self):
        """Runs the cycle: what the program did, how it was called, the folder of its report."""
        report = self.config.invocation_params.dir / value_of(self.config, "report") / f"{self.dialect}.{self.cycle}"
        command = self.command(report)
        return gauge(self.config, *command), command, report

    def command(self, report):
        words = ["certify", "--subject", value_of(self.config, "subject"), "--dialect", self.dialect,
                 "--cycle", self.cycle, "--report", str(report), *corpus_words(self.config)]
        for name in HANDED_ON:
            for value in value_of(self.config, name):
                words += [f"--{name}", value]
        return words


class CycleTest(Campaign, pytest.Item):
    def runtest(self):
        done, command, report = self.certify()
        claimed = done.returncode != UNDECIDED or is_claimed(report / "results.jsonl")
        self.user_properties += [("gonogo_dialect", self.dialect), ("gonogo_judged", claimed)]
        if not claimed:
            pytest.skip(f"the subject claims no case of {self.cycle}")
        if done.returncode != GO:
            raise NotGo(done.stdout, command, report)

    def repr_failure(self, excinfo, style=None):
        if isinstance(excinfo.value, NotGo):
            return failure_text(excinfo.value)
        return super().repr_failure(excinfo, style)

    def reportinfo(self):
        return self.path, None, self.name


class CaseTests(Campaign, pytest.Collector):
    """The cases of a cycle, each a test that tells what the run of the cycle said of it."""

    def collect(self):
        done, _, report = self.certify()
        if done.returncode not in (GO, NO_GO, UNDECIDED):
            raise self.CollectError(done.stdout)
        with open(report / "results.jsonl", encoding="utf-8", errors="replace") as results:
            for case in map(json.loads, results):
                if "id" in case:
                    yield CaseTest.from_parent(self, name=case["id"], case=case, report=report, dialect=self.dialect)


class CaseFailed(Exception):
    """A case that is NO-GO."""


class CaseTest(pytest.Item):
    def __init__(self, *, case, report, dialect, **rest):
        super().__init__(**rest)
        self.case, self.report, self.dialect = case, report, dialect

    def runtest(self):
        verdict, message = self.case["verdict"], self.case.get("message", "")
        judged = verdict not in ("skip", "oracle-gap", "advice")
        self.user_properties += [("gonogo_dialect", self.dialect), ("gonogo_judged", judged)]
        if verdict == "xfail":
            pytest.xfail(self.case.get("known", message))
        if not judged:
            pytest.skip(f"{verdict}: {message}")
        if not verdict.startswith("pass"):
            raise CaseFailed(verdict)

    def repr_failure(self, excinfo, style=None):
        if not isinstance(excinfo.value, CaseFailed):
            return super().repr_failure(excinfo, style)
        told = self.report / "programs" / f"{self.case['id']}.txt"
        if told.is_file():
            return told.read_text(encoding="utf-8", errors="replace").rstrip()
        return f"{self.case['verdict']}: {self.case.get('message', '')}"

    def reportinfo(self):
        return self.path, None, self.name


def is_claimed(results):
    """Whether the subject took up at least one case of a run without a decision."""
    try:
        footer = json.loads(results.read_text(errors="replace").splitlines()[-1])
        return set(footer["totals"]) != {"skip"}
    except (OSError, ValueError, LookupError, TypeError):
        return True


def failure_text(failure):
    """The findings as the program tells them, then the program of the first one's smallest case."""
    text = failure.output.rstrip()
    for case in re.findall(r"\b[a-z0-9_-]+(?:\.[a-z0-9_-]+)+\b", failure.output):
        path = Path(failure.report) / "programs" / f"{case}.nc"
        if path.is_file():
            lines = path.read_text(errors="backslashreplace").splitlines()
            numbered = "\n".join(f"{number:>6}  {line}" for number, line in enumerate(lines, 1))
            text += f"\n\nprogram of {case}:\n{numbered}"
            break
    return f"{text}\n\nagain: gonogo {shlex.join(failure.command)}"
