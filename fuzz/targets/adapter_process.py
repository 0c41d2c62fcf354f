"""A program that speaks the adapter protocol, in a separate process with limits.

If it hangs, crashes, writes garbage or too much, this becomes a Failure, never an error of ours.
"""

from __future__ import annotations

import json
import os
import selectors
import subprocess
import sys
import time
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from minkref.errors import LONGEST_MESSAGE, cut
from minkref.fuzz.isolation.isolation import usual
from minkref.fuzz.isolation.supervised_program import WATCH_SECONDS, SupervisedProgram
from minkref.fuzz.targets.answer import Limits, load_limit
from minkref.fuzz.targets.declaration import Declaration, DeclarationError, read_declaration
from minkref.fuzz.verdicts.verdict import Verdict
from minkref.version import version

PROTOCOLS = ("adapter-v1",)
GAVE_UP = "gave-up"
STATUSES = ("result", "skipped", "errored", "rejected", GAVE_UP)
LONGEST_INTEGER = 100_000  # digits
LOG_BYTES = 4096  # kept from the end of its standard error
MEMORY_WORDS = ("bad_alloc", "memoryerror", "out of memory", "cannot allocate")
STOP_SECONDS = 2.0


class Failure(Exception):
    """The outcome of an unanswered request."""

    def __init__(
        self, verdict: Verdict, message: str, signal_name: str | None = None, log: str = ""
    ) -> None:
        super().__init__(message)
        self.verdict, self.message, self.signal, self.log = verdict, message, signal_name, log


@dataclass
class AdapterProcess:
    """Started at the first request, and anew after a failure. For one thread."""

    name: str
    command: list[str]
    limits: Limits
    environment: dict[str, str] = field(default_factory=dict)
    declaration: Declaration | None = None
    _program: SupervisedProgram | None = None
    _sequence: int = 0
    _rest: bytes = b""
    _log: bytes = b""

    def start(self) -> Declaration:
        """The declaration; starts the program if it does not run. Raises Failure."""
        if self._program is not None and self.declaration:
            if self._program.process.poll() is None:
                return self.declaration
            raise self._died(b"")
        self.close()
        self._rest, self._log = b"", b""
        try:
            isolation = self.limits.isolation or usual()
            limits = self.limits
            program = SupervisedProgram(
                self.command, limits.bytes, limits.processes, isolation, self.environment
            )
        except (OSError, subprocess.SubprocessError) as error:
            raise Failure(Verdict.ERRORED, f"cannot be started: {error}") from error
        self._program = program
        for stream in (program.process.stdin, program.process.stdout, program.process.stderr):
            assert stream is not None
            os.set_blocking(stream.fileno(), False)
        answer = self.ask(
            "hello", load_limit(self.limits), protocols=list(PROTOCOLS), minkref=version()
        )
        if answer["status"] != "result":
            why = answer.get("reason") or f"hello is answered by {answer['status']}"
            raise self._fault(why, Verdict.ERRORED)
        if answer.get("protocol") not in PROTOCOLS:
            what = f"its protocol is {_short(answer.get('protocol'))}"
            raise self._fault(f"{what}, not one of {', '.join(PROTOCOLS)}", Verdict.ERRORED)
        try:
            self.declaration = read_declaration(answer, self.name)
        except DeclarationError as error:
            raise self._fault(f"its declaration: {error}", Verdict.ERRORED) from error
        return self.declaration

    def ask(self, verb: str, seconds: float, **members: Any) -> dict[str, Any]:
        """Returns the answer to one request, with its status checked. Without an answer, raises
        Failure and ends the program."""
        self._sequence += 1
        request = {"seq": self._sequence, "verb": verb, **members}
        line = self._exchange(json.dumps(request).encode() + b"\n", seconds)
        try:
            answer = _parsed(line)
        except (ValueError, RecursionError) as error:
            raise self._fault(
                f"{verb} is answered by a line that is not JSON: {_short(_text(line))}",
                Verdict.ERRORED,
            ) from error
        if not isinstance(answer, dict) or answer.get("status") not in STATUSES:
            raise self._fault(
                f"{verb} is answered without a status: {_short(_text(line))}", Verdict.ERRORED
            )
        if answer.get("seq") != self._sequence or isinstance(answer.get("seq"), bool):
            what = f"{verb}: the answer has seq {_short(answer.get('seq'))}, the request had "
            raise self._fault(f"{what}{self._sequence}", Verdict.ERRORED)
        if answer["status"] != "result" and not isinstance(answer.get("reason", ""), str):
            raise self._fault(f"{verb}: the reason is no text", Verdict.ERRORED)
        if answer["status"] == "errored":
            answer["reason"] = self._explained(answer.get("reason", ""))
        return answer

    @property
    def log(self) -> str:
        """The end of the program's standard error."""
        return _text(self._log)

    def close(self) -> None:
        """Ends the program with all its descendants."""
        if self._program is not None and self._program.process.poll() is None:
            self._stop(self._program.process)
        self._end()

    def _stop(self, process: subprocess.Popen[bytes]) -> None:
        """Asks it to end."""
        try:
            assert process.stdin is not None
            process.stdin.write(
                json.dumps({"seq": self._sequence + 1, "verb": "stop"}).encode() + b"\n"
            )
            process.stdin.close()
            process.wait(STOP_SECONDS)
        except (OSError, subprocess.TimeoutExpired):
            pass

    def _exchange(self, request: bytes, seconds: float) -> bytes:
        assert self._program is not None
        process = self._program.process
        assert process.stdin and process.stdout and process.stderr
        deadline = time.monotonic() + seconds
        sent = logged = 0
        answer = bytearray(self._rest)
        searched = 0  # bytes without a line's end
        if b"\n" in answer:
            raise self._fault("it wrote a line that nobody asked for", Verdict.ERRORED)
        open_ends = {process.stdout, process.stderr}
        with selectors.DefaultSelector() as selector:
            selector.register(process.stdout, selectors.EVENT_READ)
            selector.register(process.stderr, selectors.EVENT_READ)
            selector.register(process.stdin, selectors.EVENT_WRITE)
            while True:
                remaining = deadline - time.monotonic()
                wait = max(0.0, min(remaining, WATCH_SECONDS))
                ready = selector.select(wait) if remaining > 0 else []
                if self._program.exceeded():
                    raise self._too_much_memory()
                if not ready and remaining <= 0:
                    partly = f", after {len(answer):,} bytes of one" if answer else ""
                    raise self._fault(f"no answer in {seconds:g} s{partly}", Verdict.TIMED_OUT)
                for key, _ in ready:
                    if key.fileobj is process.stdin:
                        try:
                            sent += os.write(key.fd, request[sent : sent + 65536])
                        except BlockingIOError:
                            continue
                        except OSError:
                            selector.unregister(process.stdin)
                            continue
                        if sent == len(request):
                            selector.unregister(process.stdin)
                        continue
                    try:
                        piece = os.read(key.fd, 1 << 20)
                    except BlockingIOError:
                        continue
                    if not piece:
                        selector.unregister(key.fileobj)
                        open_ends.discard(key.fileobj)
                    elif key.fileobj is process.stderr:
                        logged += len(piece)
                        self._log = (self._log + piece)[-LOG_BYTES:]
                    else:
                        answer += piece
                length = answer.find(b"\n", searched)
                if length >= 0:
                    self._rest = bytes(answer[length + 1 :])
                    return bytes(answer[:length])
                searched = len(answer)
                if len(answer) + logged > self.limits.output:
                    log = f", {logged:,} of them log" if logged else ""
                    what = f"an answer of more than {self.limits.output:,} bytes{log}"
                    raise self._fault(f"{what} (--call-output)", Verdict.ERRORED)
                if process.stdout not in open_ends:
                    raise self._died(bytes(answer))

    def _died(self, partial: bytes) -> Failure:
        program = self._program
        assert program is not None
        try:
            code = program.process.wait(STOP_SECONDS)
        except subprocess.TimeoutExpired:
            return self._fault("it closed its output and runs on", Verdict.ERRORED)
        self._drain()
        if program.exceeded():
            return self._too_much_memory()
        code, name = program.exit_of(code)
        half = f", in the middle of a line: {_short(_text(partial))}" if partial else ""
        verdict = Verdict.CRASHED
        if any(word in self.log.lower() for word in MEMORY_WORDS):
            verdict = Verdict.OUT_OF_MEMORY
        return self._fault(f"it ended ({name or f'exit code {code}'}){half}", verdict, name)

    def _drain(self) -> None:
        assert self._program is not None and self._program.process.stderr is not None
        try:
            while piece := os.read(self._program.process.stderr.fileno(), 1 << 16):
                self._log = (self._log + piece)[-LOG_BYTES:]
        except OSError:
            pass

    def _too_much_memory(self) -> Failure:
        most = f"{self.limits.bytes >> 20:,} MiB"
        what = f"it took more than {most}, with all that it started (--call-memory)"
        return self._fault(what, Verdict.OUT_OF_MEMORY)

    def _fault(self, message: str, verdict: Verdict, signal_name: str | None = None) -> Failure:
        """Ends the program."""
        message = self._explained(message)
        self._end()
        self.declaration = None
        return Failure(verdict, message, signal_name, self.log)

    def _explained(self, message: str) -> str:
        """The message about a fault, with a possible cause."""
        why = f"; it wanted more than {self.limits.processes:,} processes (--call-processes)"
        if self._program is None or not self._program.crowded() or message.endswith(why):
            return cut(message)
        return cut(message)[: LONGEST_MESSAGE - len(why)] + why

    def _end(self) -> None:
        program, self._program = self._program, None
        if program is None:
            return
        program.end()
        for stream in (program.process.stdin, program.process.stdout, program.process.stderr):
            if stream:
                with suppress(OSError):
                    stream.close()


def _parsed(line: bytes) -> Any:
    """Returns the JSON value. ValueError also for integers so long that reading takes minutes."""
    before = sys.get_int_max_str_digits()
    sys.set_int_max_str_digits(LONGEST_INTEGER)
    try:
        return json.loads(line)
    finally:
        sys.set_int_max_str_digits(before)


def _text(data: bytes) -> str:
    return data.decode("utf-8", "replace")


def _short(value: Any) -> str:
    text = value if isinstance(value, str) else json.dumps(value)
    return text if len(text) <= 120 else text[:117] + "..."


def named_command(name: str) -> list[str]:
    """Returns the command line for a TARGET that is a path with a slash, or `cmd:COMMAND`."""
    import shlex
    import shutil

    from minkref.errors import Refusal

    if name.startswith("cmd:"):
        try:
            parts = shlex.split(name.removeprefix("cmd:"))
        except ValueError as error:
            what = f"this is no command line: {error}"
            raise Refusal(what, name, "quote it as for a shell") from error
        if not parts or shutil.which(parts[0]) is None:
            raise Refusal("there is no such program", name, "check the name and PATH")
        return parts
    path = Path(name).absolute()  # for a bare name the system would search PATH
    if not path.is_file():
        raise Refusal("there is no such program", name, "check the path")
    if os.access(path, os.X_OK):
        return [str(path)]
    runners = {".py": sys.executable, ".js": shutil.which("node")}
    runner = runners.get(path.suffix)
    if runner is None:
        raise Refusal(
            "this file is not executable", name, f"chmod +x {name}, or write cmd:INTERPRETER {name}"
        )
    return [runner, str(path)]
