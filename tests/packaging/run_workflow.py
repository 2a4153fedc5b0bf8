# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the steps of an action or of a job as its service would, as far as they are commands.

A composite action of GitHub: `${{ }}` are worked out, `run:` steps run in the folder of the job with the files
that GITHUB_OUTPUT and its like name, `uses:` steps are handed to a function. A job of GitLab: `extends`, its
variables, before_script and script as one shell script, as the runner does."""
import os
import re
import subprocess
from pathlib import Path

import yaml

EXPRESSION = re.compile(r"\$\{\{\s*(.*?)\s*\}\}", re.DOTALL)


class Failed(Exception):
    """A step exited with another code than 0."""

    def __init__(self, step, code, output):
        super().__init__(f"{step} exits with {code}:\n{output[-3000:]}")
        self.step, self.code, self.output = step, code, output


def read(path):
    return yaml.safe_load(Path(path).read_text())


class Expressions:
    """`inputs.x`, `steps.x.outputs.y`, `github.x`; == and !=, && and quoted texts; nothing else is known."""

    def __init__(self, context):
        self.context = context

    def value(self, text):
        text = text.strip()
        if "&&" in text:
            return all(self.is_true(self.value(part)) for part in text.split("&&"))
        for sign, same in (("==", True), ("!=", False)):
            if sign in text:
                left, right = text.split(sign)
                return (self.value(left) == self.value(right)) is same
        if text.startswith("'") and text.endswith("'"):
            return text[1:-1]
        place = self.context
        for name in text.split("."):
            if name not in place:
                # A step that has not run has no outputs; any other name is a mistake of the file.
                if text.startswith("steps.") and text.split(".")[1] in self.context["steps"]:
                    return ""
                raise KeyError(f"the expression {text} names nothing")
            place = place[name]
        return place

    @staticmethod
    def is_true(value):
        return value not in (False, "", None)

    def filled(self, text):
        return EXPRESSION.sub(lambda found: str(self.value(found[1])), str(text))


class CompositeAction:
    """`place`: the folder of the job; `action`: that of the action; `uses` takes the other steps."""

    def __init__(self, action, place, temporary, uses):
        self.file, self.place, self.temporary, self.uses = read(Path(action) / "action.yml"), Path(place), temporary, uses
        self.action = Path(action)
        self.summary, self.outputs, self.log, self.ran = "", {}, "", []

    def inputs(self, given):
        known = self.file["inputs"]
        for name in given:
            if name not in known:
                raise KeyError(f"the action has no input {name}")
        for name, about in known.items():
            if about.get("required") and name not in given:
                raise KeyError(f"the input {name} is needed")
        return {name: given.get(name, about.get("default", "")) for name, about in known.items()}

    def run(self, given, github):
        context = {"inputs": self.inputs(given), "steps": {},
                   "github": {"action_path": str(self.action), **github}}
        expressions = Expressions(context)
        try:
            for step in self.file["runs"]["steps"]:
                context["steps"].setdefault(step.get("id", step["name"]), {"outputs": {}})
                if "if" in step and not expressions.is_true(expressions.value(step["if"])):
                    continue
                self.ran.append(step["name"])
                if "uses" in step:
                    words = {key: expressions.filled(value) for key, value in step["with"].items()}
                    self.uses(step["uses"], words)
                else:
                    context["steps"][step.get("id", step["name"])]["outputs"] = self.command(step, expressions)
        finally:
            self.outputs = {name: expressions.filled(about["value"]) for name, about in self.file["outputs"].items()
                            if EXPRESSION.match(about["value"])[1].split(".")[1] in context["steps"]}
        return self.outputs

    def command(self, step, expressions):
        if step["shell"] != "bash":
            raise KeyError(f"the shell {step['shell']} is not known")
        files = {name: self.temporary / name for name in ("GITHUB_OUTPUT", "GITHUB_STEP_SUMMARY")}
        for file in files.values():
            file.write_text("")
        environment = {"PATH": os.environ["PATH"], "HOME": str(self.temporary), "RUNNER_TEMP": str(self.temporary),
                       "GITHUB_ACTIONS": "true", "LANG": "C.UTF-8"}
        environment.update({name: str(file) for name, file in files.items()})
        environment.update({name: expressions.filled(value) for name, value in step.get("env", {}).items()})
        done = subprocess.run(["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c",
                               expressions.filled(step["run"])], cwd=self.place, env=environment, text=True,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        self.log += done.stdout
        self.summary += files["GITHUB_STEP_SUMMARY"].read_text()
        if done.returncode != 0:
            raise Failed(step["name"], done.returncode, done.stdout)
        return dict(line.split("=", 1) for line in files["GITHUB_OUTPUT"].read_text().splitlines())


def run_gitlab_job(path, name, place, variables, tools):
    """Runs a job in `place`; `tools` is a folder of programs that come first. Gives code, output and the job."""
    jobs = read(path)
    job = dict(jobs[name])
    for key, value in jobs.get(job.get("extends"), {}).items():
        job.setdefault(key, value)
    script = "set -eo pipefail\n" + "\n".join([*job["before_script"], *job["script"]])
    environment = {"PATH": f"{tools}:{os.environ['PATH']}", "HOME": str(place), "CI": "true", "LANG": "C.UTF-8",
                   **{key: str(value) for key, value in job.get("variables", {}).items()}, **variables}
    done = subprocess.run(["bash", "-c", script], cwd=place, env=environment, text=True, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    return done.returncode, done.stdout, job
