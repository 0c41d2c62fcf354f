"""How a program may end."""

from __future__ import annotations

import os
import resource
import signal
from typing import ClassVar

from honest import Adapter, Request


class Exits(Adapter):
    """Exits with the exit code from its options, and answers no `at`."""

    instead = "at"

    def mischief(self, request: Request) -> None:
        os._exit(int(self.told.get("first", "70")))


class ExitsInHello(Exits):
    instead = "hello"


class ExitsInLoad(Exits):
    instead = "load"


class ExitsAtOnce(Adapter):
    """Before it has read a word."""

    def serve(self) -> None:
        os._exit(int(self.told.get("first", "0")))


class Dies(Adapter):
    """Dies by the signal from its options."""

    instead = "at"

    def mischief(self, request: Request) -> None:
        number = int(self.told.get("first", str(signal.SIGSEGV)))
        if number not in (signal.SIGKILL, signal.SIGSTOP):
            signal.signal(number, signal.SIG_DFL)
        os.kill(os.getpid(), number)


class DumpsItsCore(Adapter):
    """Dies, and leaves its memory as a file in its working folder."""

    instead = "at"

    def mischief(self, request: Request) -> None:
        hard = resource.getrlimit(resource.RLIMIT_CORE)[1]
        resource.setrlimit(resource.RLIMIT_CORE, (hard, hard))
        os.abort()


class HangsInHello(Adapter):
    """Says nothing at all."""

    instead = "hello"

    def mischief(self, request: Request) -> None:
        from processes import linger

        linger()


class RejectsAll(Adapter):
    """Rejects valid input."""

    reason: ClassVar[str] = "I do not like it"

    def at(self, request: Request) -> dict[str, object]:
        return {"status": "rejected", "reason": self.reason}


class ReasonsAreNoTexts(Adapter):
    """`reason` is anything but a text, or lacks."""

    count = 0

    def at(self, request: Request) -> dict[str, object]:
        self.count += 1
        reasons = [None, 7, ["a"], {"b": 1}, "x" * 5_000_000]
        status = ["skipped", "errored", "rejected"][self.count % 3]
        answer: dict[str, object] = {"status": status}
        return answer if self.count % 6 == 0 else {**answer, "reason": reasons[self.count % 5]}
