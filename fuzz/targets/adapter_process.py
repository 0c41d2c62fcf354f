"""A program that speaks the adapter protocol, in a process of its own with limits.

Whatever it does, hangs, crashes, writes garbage or too much, becomes a Failure, never an error of
ours.
"""

from __future__ import annotations

import json
import os
import resource
import selectors
import signal
import subprocess
import sys
import time
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from minkref.errors import cut
from minkref.fuzz.targets.answer import Limits, load_limit
from minkref.fuzz.targets.declaration import Declaration, DeclarationError, read_declaration
from minkref.fuzz.targets.keeper import end, keep
from minkref.fuzz.verdicts.verdict import Verdict
from minkref.version import version

PROTOCOLS = ("adapter-v1",)
STATUSES = ("result", "skipped", "errored", "rejected")
LONGEST_INTEGER = 100_000  # digits
LOG_BYTES = 4096  # of the end of its standard error that are kept
MEMORY_WORDS = ("bad_alloc", "memoryerror", "out of memory", "cannot allocate")
STOP_SECONDS = 2.0


class Failure(Exception):
    """What became of a request that has no answer."""

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
    _process: subprocess.Popen[bytes] | None = None
    _sequence: int = 0
    _rest: bytes = b""
    _log: bytes = b""

    def start(self) -> Declaration:
        """The declaration; starts the program if it does not run. Raises Failure."""
        if self._process is not None and self.declaration:
            if self._process.poll() is None:
                return self.declaration
            raise self._died(b"")
        self.close()
        self._rest, self._log = b"", b""
        try:
            self._process = subprocess.Popen(
                self.command,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                bufsize=0,
                env={**os.environ, **self.environment},
                preexec_fn=_child_setting(self.limits.bytes),
            )
        except (OSError, subprocess.SubprocessError) as error:
            raise Failure(Verdict.ERRORED, f"cannot be started: {error}") from error
        for stream in (self._process.stdin, self._process.stdout, self._process.stderr):
            assert stream is not None
            os.set_blocking(stream.fileno(), False)
        answer = self.ask(
            "hello", load_limit(self.limits), protocols=list(PROTOCOLS), minkref=version()
        )
        if answer["status"] != "result":
            raise self._fault(f"hello is answered by {answer['status']}", Verdict.ERRORED)
        if answer.get("protocol") not in PROTOCOLS:
            what = f"its protocol is {_short(answer.get('protocol'))}"
            raise self._fault(f"{what}, not one of {', '.join(PROTOCOLS)}", Verdict.ERRORED)
        try:
            self.declaration = read_declaration(answer, self.name)
        except DeclarationError as error:
            raise self._fault(f"its declaration: {error}", Verdict.ERRORED) from error
        return self.declaration

    def ask(self, verb: str, seconds: float, **members: Any) -> dict[str, Any]:
        """The answer to one request, its status checked. Raises Failure, and ends the program,
        where there is none."""
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
        return answer

    @property
    def log(self) -> str:
        """The end of what the program wrote to standard error."""
        return _text(self._log)

    def close(self) -> None:
        """Ends the program with all that it started."""
        process, self._process = self._process, None
        if process is None:
            return
        if process.poll() is None:
            self._stop(process)
        end(process)
        for stream in (process.stdin, process.stdout, process.stderr):
            if stream:
                try:
                    stream.close()
                except OSError:
                    pass

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
        process = self._process
        assert process and process.stdin and process.stdout and process.stderr
        deadline = time.monotonic() + seconds
        sent = 0
        answer = bytearray(self._rest)
        searched = 0  # bytes in which there is no end of a line
        if b"\n" in answer:
            raise self._fault("it wrote a line that nobody asked for", Verdict.ERRORED)
        open_ends = {process.stdout, process.stderr}
        with selectors.DefaultSelector() as selector:
            selector.register(process.stdout, selectors.EVENT_READ)
            selector.register(process.stderr, selectors.EVENT_READ)
            selector.register(process.stdin, selectors.EVENT_WRITE)
            while True:
                remaining = deadline - time.monotonic()
                ready = selector.select(max(0.0, remaining)) if remaining > 0 else []
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
                        self._log = (self._log + piece)[-LOG_BYTES:]
                    else:
                        answer += piece
                length = answer.find(b"\n", searched)
                if length >= 0:
                    self._rest = bytes(answer[length + 1 :])
                    return bytes(answer[:length])
                searched = len(answer)
                if len(answer) > self.limits.output:
                    what = f"an answer of more than {self.limits.output:,} bytes (--call-output)"
                    raise self._fault(what, Verdict.ERRORED)
                if process.stdout not in open_ends:
                    raise self._died(bytes(answer))

    def _died(self, partial: bytes) -> Failure:
        process = self._process
        assert process is not None
        try:
            code = process.wait(STOP_SECONDS)
        except subprocess.TimeoutExpired:
            return self._fault("it closed its output and runs on", Verdict.ERRORED)
        self._drain()
        name = None
        if code < 0:
            try:
                name = signal.Signals(-code).name
            except ValueError:
                name = f"signal {-code}"
        half = f", in the middle of a line: {_short(_text(partial))}" if partial else ""
        verdict = Verdict.CRASHED
        if any(word in self.log.lower() for word in MEMORY_WORDS):
            verdict = Verdict.OUT_OF_MEMORY
        return self._fault(f"it ended ({name or f'exit code {code}'}){half}", verdict, name)

    def _drain(self) -> None:
        process = self._process
        assert process is not None and process.stderr is not None
        try:
            while piece := os.read(process.stderr.fileno(), 1 << 16):
                self._log = (self._log + piece)[-LOG_BYTES:]
        except OSError:
            pass

    def _fault(self, message: str, verdict: Verdict, signal_name: str | None = None) -> Failure:
        """Ends the program."""
        process, self._process = self._process, None
        self.declaration = None
        if process is not None:
            end(process)
            for stream in (process.stdin, process.stdout, process.stderr):
                if stream:
                    stream.close()
        return Failure(verdict, cut(message), signal_name, self.log)


def _child_setting(memory: int) -> Any:
    parent = os.getpid()

    def begin() -> None:
        keep(parent)
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        _, hard = resource.getrlimit(resource.RLIMIT_AS)
        if hard == resource.RLIM_INFINITY or memory < hard:
            resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    return begin


def _parsed(line: bytes) -> Any:
    """The JSON value. ValueError also for integers so long that reading them takes minutes."""
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
    """The command line of a TARGET that is a path with a slash in it, or `cmd:COMMAND`."""
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
    path = Path(name).absolute()  # of a name alone the system would search PATH
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
