"""Conversations with adapters, line by line."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path
from threading import Timer
from typing import Any

import pytest

SECONDS = 120


class Conversation:
    """A running adapter; its log goes to a file."""

    def __init__(self, command: list[str], log: Path) -> None:
        with log.open("wb") as file:
            self.process = subprocess.Popen(
                command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=file, text=True
            )
        self.seq = 0
        self.end = Timer(SECONDS, self.process.kill)  # an adapter that hangs ends the test
        self.end.start()

    def line(self, text: str) -> dict[str, Any]:
        """Sends a line, valid or not, and returns the answer."""
        assert self.process.stdin and self.process.stdout
        self.process.stdin.write(text + "\n")
        self.process.stdin.flush()
        answer: dict[str, Any] = json.loads(self.process.stdout.readline())
        return answer

    def ask(self, verb: str, **members: Any) -> dict[str, Any]:
        self.seq += 1
        answer = self.line(json.dumps({"seq": self.seq, "verb": verb, **members}))
        assert answer["seq"] == self.seq
        return answer

    def hello(self) -> dict[str, Any]:
        return self.ask("hello", protocols=["adapter-v1"], minkref="0.1.0")

    def sum(self, P: dict[str, Any], Q: dict[str, Any]) -> dict[str, Any]:
        """The answer to `at`; the answer to `load` if that is no result."""
        dimension = 2 if "polygons" in P else 3
        loaded = self.ask("load", dimension=dimension, P=P, Q=Q)
        return loaded if loaded["status"] != "result" else self.ask("at", scale="1", sP=P)

    def stop(self) -> int:
        """The exit code."""
        self.ask("stop")
        return self.process.wait(SECONDS)


@pytest.fixture
def converse(tmp_path: Path) -> Iterator[Callable[[list[str]], Conversation]]:
    """Starts an adapter; whatever still runs is ended."""
    started: list[Conversation] = []

    def start(command: list[str]) -> Conversation:
        started.append(Conversation(command, tmp_path / f"log{len(started)}"))
        return started[-1]

    yield start
    for conversation in started:
        conversation.end.cancel()
        conversation.process.kill()
        conversation.process.communicate()
