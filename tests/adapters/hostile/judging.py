"""Faults of a run under attack: held against docs/adapter-protocol.md, docs/verify.md and
docs/security.md."""

from __future__ import annotations

import json
import os
from xml.etree import ElementTree

from attack import WRITTEN, Seen
from attacks import NONE, Attack
from markdown_it import MarkdownIt
from reading import obeyed

SCRIPT = "<script>alert("  # as hostile adapters name themselves
CODES = (0, 1, 2, 3)
# The run itself keeps this for a user: the key that chains ledgers.
KEPT = ".local"


def faults_of(attack: Attack, seen: Seen, sandboxed: bool) -> list[str]:
    """The faults, each in a few words; none if the run keeps all promises."""
    alone = not sandboxed
    if alone and attack.kills and os.geteuid() != 0 and seen.code not in CODES:
        return traces(attack, seen, alone)  # it may end us: what counts is what is left
    faults = ends(attack, seen) + traces(attack, seen, alone)
    may = attack.alone if alone else attack.inside
    reached = [word for word in got(seen) if word not in may]
    if reached:
        faults.append(f"it got at {' '.join(reached)}")
    if seen.connections and not {"tcp", "udp", "unix"} & set(may):
        faults.append(f"{seen.connections} connections")
    return faults + outputs(seen) + terminal(attack, seen)


def got(seen: Seen) -> list[str]:
    """The things that the adapter reached, as its version tells."""
    words = [word for word in seen.version.split() if word.startswith("got:")]
    return sorted({word.removeprefix("got:") for word in words})


def public(trace: str) -> bool:
    """Whether anybody may leave such a trace."""
    return trace.startswith(
        ("/tmp/", "/var/tmp/", "/dev/shm/", "/dev/mqueue/", "shm", "sem", "msg")
    )


def ends(attack: Attack, seen: Seen) -> list[str]:
    """Exit code, document and verdicts."""
    faults = []
    if seen.code not in CODES:
        faults.append("no end in time" if seen.code is None else f"exit code {seen.code}")
    ours = "the end of its log" not in seen.stderr
    if "Traceback" in seen.stderr and ours:
        faults.append("a traceback")
    if seen.document is None:
        return [*faults, "no document"]
    if not attack.verdicts:
        return faults + ([] if seen.code == 2 else [f"it began: {seen.verdicts()}"])
    error = seen.document.get("error", {})
    unloaded = str(error.get("what", "")).startswith("the function cannot be loaded: ")
    if (unloaded or error.get("code") == NONE) and NONE in attack.verdicts:
        return faults
    if error:
        return [*faults, f"refused: {str(error.get('what'))[:300]}"]
    verdicts, beside = seen.verdicts(), seen.verdicts(ours=True)
    if not verdicts or not set(verdicts) <= {*attack.verdicts, "skipped"}:
        faults.append(f"verdicts {verdicts}, not {' or '.join(attack.verdicts)}")
    if not beside or not set(beside) <= {"pass", "skipped"}:
        faults.append(f"the target beside it has {beside}")
    return faults


def traces(attack: Attack, seen: Seen, alone: bool) -> list[str]:
    """Processes, files, sockets, shared memory."""
    faults = [f"processes are left: {seen.processes}"] if seen.processes else []
    if seen.temporary:
        faults.append(f"temporary files are left: {seen.temporary[:3]}")
    outside = [trace for trace in seen.outside if not (alone and attack.leaves and public(trace))]
    if outside:
        faults.append(f"outside: {outside}")
    if home := [name for name in seen.home if not name.startswith(KEPT)]:
        faults.append(f"the user's folder: {home[:3]}")
    if seen.work:
        faults.append(f"the run's folder: {seen.work[:3]}")
    return faults


def outputs(seen: Seen) -> list[str]:
    """Faults of output files, which must be well-formed with any text inside."""
    faults = []
    for name, text in seen.files.items():
        if name not in WRITTEN and not name.startswith("report/"):
            continue
        try:
            if name.endswith(".xml"):
                ElementTree.fromstring(text.encode())
            elif name.endswith((".ledger", ".jsonl")):
                for line in text.splitlines():
                    json.loads(line)
            elif name.endswith((".sarif", ".json")):
                json.loads(text)
        except (ValueError, ElementTree.ParseError) as error:
            faults.append(f"{name}: {str(error)[:80]}")
        if name.endswith(".md"):
            text = MarkdownIt("commonmark", {"html": True}).render(text)
        if name.endswith((".html", ".md")) and SCRIPT in text:
            faults.append(f"{name} has a script of the adapter")
        if bad := sorted({repr(letter) for letter in text if obeyed(letter)}):
            faults.append(f"{name} has letters that a terminal obeys: {' '.join(bad[:9])}")
    return faults


def terminal(attack: Attack, seen: Seen) -> list[str]:
    if not attack.tty:
        return []
    found = [what for what in ("terminal_changed", "typed") if seen.terminal.get(what)]
    shown = ["shown"] if "minkref-hostile" in seen.terminal.get("shown", "") else []
    return [f"the terminal: {what}" for what in found + shown]
