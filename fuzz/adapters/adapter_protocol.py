"""The loop of an adapter in Python: requests from standard input, answers to standard output.

The protocol is in docs/adapter-protocol.md. Standard library only: an adapter runs in an
environment of its own, which knows nothing of minkref.
"""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable
from typing import Any

Set = dict[str, Any]  # {"polygons": ...} or {"vertices": ..., "faces": ...}
Sum = Callable[[Set, Set], dict[str, Any]]


class Skipped(Exception):
    """The implementation does not take this case; the text is the reason."""


class Rejected(Exception):
    """The implementation says that the input is invalid; the text is the reason."""


class Adapter:
    """Answers requests: `hello` is the declaration, `sum_of(sP, Q)` the members of a result."""

    def __init__(self, hello: dict[str, Any], sum_of: Sum) -> None:
        self.hello = hello
        self.sum_of = sum_of
        self.Q: Set | None = None

    def answer(self, request: dict[str, Any]) -> dict[str, Any]:
        """What becomes of one request, without `seq`."""
        verb = request.get("verb")
        try:
            if verb == "hello":
                return {"status": "result", "protocol": "adapter-v1", **self.hello}
            if verb == "load":
                self.Q = request["Q"]
                return {"status": "result"}
            if verb == "at":
                if self.Q is None:
                    raise ValueError("`at` before any `load`")
                return {"status": "result", **self.sum_of(request["sP"], self.Q)}
            return {"status": "skipped", "reason": f"no verb {verb!r} here"}
        except Skipped as reason:
            return {"status": "skipped", "reason": str(reason)}
        except Rejected as reason:
            return {"status": "rejected", "reason": str(reason)}
        except Exception as error:  # noqa: BLE001 whatever the implementation raises
            return {"status": "errored", "reason": f"{type(error).__name__}: {error}"[:2000]}


def serve(hello: dict[str, Any], sum_of: Sum) -> None:
    """Answers until `stop` or the end of the input. What the implementation prints goes to the
    log: it must not reach the answers."""
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    adapter = Adapter(hello, sum_of)
    for line in sys.stdin.buffer:
        if not line.strip():
            continue
        seq, stop = None, False
        try:
            request = json.loads(line)
            seq, stop = request.get("seq"), request.get("verb") == "stop"
            value = {"status": "result"} if stop else adapter.answer(request)
            text = json.dumps({"seq": seq, **value}, allow_nan=False)
        except (ValueError, AttributeError, RecursionError) as error:  # no request; not a number
            text = json.dumps({"seq": seq, "status": "errored", "reason": str(error)[:2000]})
        answers.write(text + "\n")
        answers.flush()
        if stop:
            return
