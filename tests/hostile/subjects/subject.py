#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""subject.py KIND [ARGUMENT]: a subject that answers every program wrongly, and does as KIND says.

Without a KIND that says otherwise it sends one traverse to where no program goes.
"""
import json
import os
import signal
import sys
import time

KIND, ARGUMENT = sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else ""
# Starts a line of its own, moves the cursor, hides what stands behind, and turns the writing.
NASTY = "a\nGO for everything: 9 cases, 9 judged\r\x1b[2J\u202eb\u2066c\x9bd\x7f\u200be"
WRONG = {"k": "rapid", "b": 1, "to": {"x": "777"}}


def forge_results():
    """Makes each failure in the journal a pass."""
    for name in ("results.jsonl.part", "results.jsonl.part.sorted", "results.jsonl.sorted"):
        path = os.path.join(ARGUMENT, name)
        if not os.path.exists(path):
            continue
        with open(path, "r+") as file:
            lines = file.read().split("\n")
            forged = [line.replace('"verdict":"fail.geometry"', '"verdict":"pass-exact"') for line in lines]
            file.seek(0)
            file.write("\n".join(forged))
            file.truncate()


def empty_results():
    """Takes the journal away, and leaves one with a header alone."""
    path = os.path.join(ARGUMENT, "results.jsonl.part")
    with open(path) as file:
        header = file.readline()
    os.unlink(path)
    with open(path, "w") as file:
        file.write(header)


def leave_group():
    """Goes into the group of the parent's parent, where a kill of its own does not reach it."""
    try:
        os.setpgid(0, os.getpgid(os.getppid()))
    except PermissionError:
        pass  # the parent is of another session


def daemon(work):
    """Runs `work` in a process that has left parent, session and group."""
    if os.fork() == 0:
        os.setsid()
        if os.fork() == 0:
            for fd in range(3):
                os.close(fd)
            work()
        os._exit(0)
    os.wait()


def sleep():
    time.sleep(600)


def children():
    for _ in range(40):
        if os.fork() == 0:
            signal.signal(signal.SIGTERM, signal.SIG_IGN)
            os.setsid()
            sleep()


def swarm():
    """Many more processes than a subject needs, none of them large."""
    for _ in range(3000):
        if os.fork() == 0:
            os.execvp("sleep", ["sleep", "600"])
    sleep()


def hog():
    held = []
    while True:
        held.append(bytearray(b"x" * (16 << 20)))
        time.sleep(0.01)


def hog_in_a_child():
    if os.fork() == 0:
        os.setsid()
        hog()
    sleep()


def reply_to(message):
    command = message["cmd"]
    if command == "start":
        subject = {"name": "hostile", "version": "1"}
        if KIND == "says-name":
            subject["name"] = NASTY
        if KIND == "says-version":
            subject["version"] = NASTY
        dialects = ["rs274", NASTY] if KIND == "says-dialect" else ["rs274"]
        return {"protocol": 1, "subject": subject, "dialects": dialects, "features": ["blocks"]}
    if command == "configure" and KIND == "says-refusal":
        return {"ok": False, "message": NASTY}
    if command != "run":
        return {"ok": True}
    WORK.get(KIND, lambda: None)()
    reply = {"seq": message["seq"], "outcome": "ok", "records": [WRONG]}
    if KIND == "says-error":
        reply.update({"outcome": "error", "message": NASTY})
    elif KIND == "says-skip":
        reply.update({"outcome": "skip", "feature": NASTY, "message": NASTY})
    elif KIND == "says-native":
        reply.update({"outcome": "alarm", "alarm": {"native": NASTY, "b": 1}})
    elif KIND == "says-class":
        reply.update({"outcome": "alarm", "alarm": {"class": NASTY, "b": 1}})
    elif KIND == "says-word":
        reply.update({"outcome": "alarm", "alarm": {"class": "syntax", "word": NASTY, "b": 1}})
    elif KIND == "says-notes":
        reply["notes"] = NASTY
    elif KIND == "says-key":
        reply[NASTY] = 1
    elif KIND == "says-outcome":
        reply["outcome"] = NASTY
    elif KIND == "says-record-key":
        reply["records"] = [{**WRONG, NASTY: 1}]
    elif KIND == "says-record-kind":
        reply["records"] = [{"k": NASTY}]
    elif KIND == "says-number":
        reply["records"] = [{"k": "rapid", "to": {"x": NASTY}}]
    elif KIND == "says-axis":
        reply["records"] = [{"k": "rapid", "to": {NASTY: "1"}}]
    elif KIND == "says-stderr":
        sys.stderr.write(NASTY + "\n")
        sys.stderr.flush()
    elif KIND == "answers":
        reply["records"] = ANSWERS[message["seq"] % len(ANSWERS)]
    elif KIND == "environment":
        with open(ARGUMENT, "w") as file:
            file.write("\n".join(os.environ))
    return reply


WORK = {
    "forges": forge_results,
    "empties": empty_results,
    "leaves-group": lambda: (leave_group(), sleep()),
    "daemon": lambda: daemon(sleep),
    "hangs-away": lambda: (daemon(sleep), sleep()),
    "children": children,
    "swarm": swarm,
    "hog-in-a-child": hog_in_a_child,
    "hog-away": lambda: (daemon(hog), sleep()),
    "slow": lambda: time.sleep(float(ARGUMENT)),
}
if KIND == "answers":
    with open(ARGUMENT) as lines:
        ANSWERS = [json.loads(line) for line in lines]
for line in sys.stdin:
    reply = reply_to(json.loads(line))
    if KIND == "says-raw":
        sys.stdout.write(NASTY.replace("\n", " ") + "\n")
    print(json.dumps(reply), flush=True)
