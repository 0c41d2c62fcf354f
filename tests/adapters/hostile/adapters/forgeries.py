"""Answers, ledgers, reports and names that pretend to be another's."""

from __future__ import annotations

import fcntl
import json
import os
import time
from contextlib import suppress
from pathlib import Path
from typing import Any, ClassVar

from bounds import fork, of_this_run
from honest import Adapter, Answer, Request, say
from processes import linger

NASTY = '"><script>alert("minkref-hostile")</script><!--'
SCREEN = "\x1b]0;minkref-hostile\x07\x1b[2J\x1b[31m\u202ered\u2066\x9b31m\x00"


def wrong(answer: Answer) -> Answer:
    """Replaces the sum with a wrong square."""
    square = [["0", "0"], ["1/7", "0"], ["1/7", "1/7"], ["0", "1/7"]]
    return {**answer, "polygons": [{"outer": square, "holes": []}]}


class Liar(Adapter):
    """Wrong at every case; further mischief shall hide that."""

    def at(self, request: Request) -> Answer:
        return wrong(super().at(request))


class ForgesTheLedger(Liar):
    """Answers, then turns all verdicts of every reachable ledger into passes."""

    def at(self, request: Request) -> Answer:
        if not hasattr(self, "forging"):
            self.forging = True
            if fork() == 0:
                for _ in range(100):
                    for path in ledgers(self.told):
                        forge(path)
                    time.sleep(0.05)
                os._exit(0)
        return super().at(request)


class AppendsToTheLedger(Liar):
    """Writes passes for cases to come at the end of every ledger in reach."""

    def mischief(self, request: Request) -> None:
        for path in ledgers(self.told):
            try:
                lines = path.read_text().splitlines()
                with path.open("a") as stream:
                    for line in [*lines[1:], '{"case": "convex:1:0", "verdict": "pass"}']:
                        stream.write(line.replace('"wrong"', '"pass"') + "\n")
            except OSError:
                continue


class LocksTheLedger(Adapter):
    """Takes and keeps every lock on every ledger in reach."""

    def mischief(self, request: Request) -> None:
        self.streams = []
        for path in ledgers(self.told):
            try:
                stream = path.open("a")
                fcntl.flock(stream, fcntl.LOCK_EX | fcntl.LOCK_NB)
                self.streams.append(stream)
            except OSError:
                continue


class ForgesTheReport(Liar):
    """Lays a report without findings where the report will be, and a link to elsewhere."""

    def mischief(self, request: Request) -> None:
        report = Path(self.told["work"], "report")
        with suppress(OSError):
            report.mkdir(exist_ok=True)
            (report / "index.html").write_text("minkref-hostile: all is well")
            (report / "report.html").symlink_to(Path(self.told["home"], "canary"))


class LinksTheReportElsewhere(Liar):
    """Replaces the report's folder with a link."""

    def mischief(self, request: Request) -> None:
        report = Path(self.told["work"], "report")
        with suppress(OSError):
            if report.is_dir():
                report.rename(report.with_name("minkref-hostile-report"))
            report.symlink_to(self.told["home"])


class PrintsADocument(Adapter):
    """Prints the whole document of a run without findings, instead of an answer."""

    instead = "at"

    def mischief(self, request: Request) -> None:
        say(json.dumps({"version": "0.1.0", "command": "verify", "findings": []}).encode() + b"\n")


class WritesToOurOutput(Liar):
    """The same, to the standard output of every process of the run."""

    def mischief(self, request: Request) -> None:
        for pid in of_this_run(self.run):
            try:
                with open(f"/proc/{pid}/fd/1", "w") as stream:
                    stream.write('{"findings": [], "minkref-hostile": 1}\n')
            except OSError:
                continue


class AnotherName(Liar):
    """Wrong, under the name of a right target."""

    declares: ClassVar[dict[str, Any]] = {"name": "minkref:winding", "version": "0.1.0"}


class NastyName(Liar):
    """Name, version and language are pieces of HTML, Markdown, XML and commands."""

    declares: ClassVar[dict[str, Any]] = {
        "name": NASTY + "](javascript:alert(1)) | `x` $(id)",
        "version": NASTY + "]]>&amp;\n\n# minkref-hostile\n",
        "language": NASTY,
    }


class NastyReason(Adapter):
    """A reason with the same nasty text."""

    def at(self, request: Request) -> Answer:
        return {"status": "errored", "reason": NASTY + "\n::error::x\n| a | b |\n" + "]]>"}


class ObeyTheTerminal(Adapter):
    """Letters that a terminal would obey, wherever minkref shows a text."""

    declares: ClassVar[dict[str, Any]] = {"name": SCREEN, "version": SCREEN, "language": SCREEN}

    def at(self, request: Request) -> Answer:
        os.write(2, SCREEN.encode() + b"\x9b31m\n")
        return {"status": "errored", "reason": SCREEN}


class ObeyTheTerminalInTheLog(Adapter):
    """Writes the terminal's control letters to its log and dies."""

    instead = "at"

    def mischief(self, request: Request) -> None:
        os.write(2, SCREEN.encode() + b"\x9b31m\n" + NASTY.encode())
        os._exit(3)


class AnswersAhead(Adapter):
    """With each answer those to the next ten requests."""

    def line(self, request: Request) -> bytes:
        text = super().line(request)
        ahead = [
            json.dumps({"seq": request["seq"] + k, "status": "result", "polygons": []}).encode()
            for k in range(1, 11)
        ]
        return b"\n".join([text, *ahead])


class AnswersTwice(Adapter):
    """Each answer twice, the second one wrong."""

    def line(self, request: Request) -> bytes:
        answer = {"seq": request["seq"], "status": "result", "polygons": []}
        return super().line(request) + b"\n" + json.dumps(answer).encode()


class OtherSeq(Adapter):
    """Texts, doubles, booleans, lists and huge numbers as `seq`."""

    count = 0

    def line(self, request: Request) -> bytes:
        seq = request["seq"]
        if request["verb"] in ("hello", "load"):
            return super().line(request)
        forms = [str(seq), seq + 0.5, True, [seq], {}, None, -seq, seq + 2**70, 10**4000]
        self.count += 1
        return json.dumps({"status": "skipped", "seq": forms[self.count % len(forms)]}).encode()


class AnswersBeforeItIsAsked(Adapter):
    """A child answers at random, between the answers of the parent."""

    def mischief(self, request: Request) -> None:
        if fork() == 0:
            for seq in range(3, 40):
                say(json.dumps({"seq": seq, "status": "result", "polygons": []}).encode() + b"\n")
                time.sleep(0.02)
            linger()


def ledgers(told: dict[str, str]) -> list[Path]:
    """The ledgers in the run's folder, and all ledgers that processes of the run have open."""
    found = set()
    try:
        found |= set(Path(told["work"]).glob("*.ledger"))
    except OSError:
        pass
    for pid in of_this_run(told["run"]):
        for link in Path(f"/proc/{pid}/fd").glob("*"):
            try:
                if str(link.readlink()).endswith(".ledger"):
                    found.add(link)
            except OSError:
                continue
    return sorted(found)


def forge(path: Path) -> None:
    try:
        text = path.read_text()
        forged = text.replace('"wrong"', '"pass"').replace('"errored"', '"pass"')
        if forged != text:
            with path.open("r+") as stream:
                stream.write(forged)
                stream.truncate()
    except (OSError, ValueError):
        return
