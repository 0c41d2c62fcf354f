"""The loop of an adapter in Python: requests from standard input, answers to standard output.

docs/adapter-protocol.md defines the protocol. Standard library only: an adapter runs in its own
environment, which knows nothing of minkref.
"""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Mapping
from typing import Any, BinaryIO, TextIO

Set = dict[str, Any]  # {"polygons": ...} or {"vertices": ..., "faces": ...}
Sum = Callable[[Set, Set], dict[str, Any]]
Path = Callable[[Set, Set, dict[str, Any]], dict[str, Any]]
Union = Callable[[list[Set]], dict[str, Any]]
Offset = Callable[..., dict[str, Any]]  # from P, the radius, and perhaps joins and caps
Verbs = Mapping[str, Path]
LONGEST_REASON = 4000  # characters
JOINS = ("join", "limit", "cap")  # of an offset


class Skipped(Exception):
    """The implementation does not take this case; the text is the reason."""


class Rejected(Exception):
    """The implementation rejects the input as invalid; the text gives the reason."""


class Errored(Exception):
    """No result; the text gives the reason."""


class GaveUp(Exception):
    """The implementation says that it cannot tell; the text gives the reason."""


class Adapter:
    """Answers requests: `hello` is the declaration, `sum_of(sP, Q)` returns a result's members, and
    each function of `verbs`, by verb, a result's members from P, Q and the request: `path`,
    `update`, or `at` itself for an implementation that scales P by itself. `union_of(sets)` returns
    the members of a union, `offset_of(P, radius)` those of P grown by a disc, and
    `features_of(P, radius)` bars and bridges. If an offset's request says joins or caps,
    `offset_of` gets them in a dictionary after the radius."""

    def __init__(
        self,
        hello: dict[str, Any],
        sum_of: Sum | None,
        verbs: Verbs,
        union_of: Union | None = None,
        offset_of: Offset | None = None,
        features_of: Offset | None = None,
    ) -> None:
        self.hello = hello
        self.sum_of = sum_of
        self.verbs = verbs
        self.union_of = union_of
        self.with_radius = {"offset": offset_of, "features": features_of}
        self.P: Set | None = None
        self.Q: Set | None = None

    def answer(self, request: dict[str, Any]) -> dict[str, Any]:
        """The answer to one request, without `seq`."""
        verb = request.get("verb")
        try:
            if verb == "hello":
                return {"status": "result", "protocol": "adapter-v1", **self.hello}
            if verb == "load":
                self.P, self.Q = request.get("P"), request["Q"]
                return {"status": "result"}
            if verb == "union" and self.union_of is not None:
                return {"status": "result", **self.union_of(request["sets"])}
            answer_of = self.with_radius.get(str(verb))
            if answer_of is not None:
                how = {word: request[word] for word in JOINS if word in request}
                more = (how,) if how else ()
                return {"status": "result", **answer_of(request["P"], request["radius"], *more)}
            if isinstance(verb, str) and verb in self.verbs:
                if self.P is None or self.Q is None:
                    raise ValueError(f"`{verb}` before any `load`")
                return {"status": "result", **self.verbs[verb](self.P, self.Q, request)}
            if verb == "at" and self.sum_of is not None:
                if self.Q is None:
                    raise ValueError("`at` before any `load`")
                return {"status": "result", **self.sum_of(request["sP"], self.Q)}
            return {"status": "skipped", "reason": f"no verb {verb!r} here"}
        except Skipped as reason:
            return {"status": "skipped", "reason": str(reason)}
        except Rejected as reason:
            return {"status": "rejected", "reason": str(reason)}
        except GaveUp as reason:
            return {"status": "gave-up", "reason": str(reason)[:LONGEST_REASON]}
        except Errored as reason:
            return {"status": "errored", "reason": str(reason)}
        except BaseException as error:  # noqa: BLE001 whatever the implementation raises
            return {"status": "errored", "reason": told(error)}


def told(error: BaseException) -> str:
    """Returns an exception's type and text, even if its `__str__` raises."""
    name = type(error).__name__
    try:
        return f"{name}: {error}"[:LONGEST_REASON]
    except BaseException:  # noqa: BLE001 its own __str__ raises
        return f"{name} (its text cannot be read)"


def streams() -> tuple[BinaryIO, TextIO]:
    """Where the requests come from and the answers go. From now on the implementation has nothing
    to read, and what it prints goes to the log."""
    requests = os.fdopen(os.dup(0), "rb")
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    nothing = os.open(os.devnull, os.O_RDONLY)
    os.dup2(nothing, 0)
    os.close(nothing)
    os.dup2(2, 1)
    return requests, answers


def serve(
    hello: dict[str, Any],
    sum_of: Sum | None,
    given: tuple[BinaryIO, TextIO] | None = None,
    path_of: Path | None = None,
    verbs: Verbs | None = None,
    union_of: Union | None = None,
    offset_of: Offset | None = None,
    features_of: Offset | None = None,
) -> None:
    """Answers until `stop` or the input's end. `given`: streams that were taken already. `path_of`
    answers the verb `path`, and `verbs` others, from P, Q and the request; `union_of` the verb
    `union`, from the sets; `offset_of` and `features_of` the verbs `offset` and `features`, from P
    and the radius."""
    requests, answers = given or streams()
    others: Verbs = {} if path_of is None else {"path": path_of}
    adapter = Adapter(hello, sum_of, {**others, **(verbs or {})}, union_of, offset_of, features_of)
    for line in requests:
        if not line.strip():
            continue
        seq, stop = None, False
        try:
            request = json.loads(line)
            seq, stop = request.get("seq"), request.get("verb") == "stop"
            value = {"status": "result"} if stop else adapter.answer(request)
            text = json.dumps({"seq": seq, **value}, allow_nan=False)
        except BaseException as error:  # noqa: BLE001 no request, or no answer that can be written
            reason = f"the answer cannot be written: {told(error)}"
            text = json.dumps({"seq": seq, "status": "errored", "reason": reason})
        answers.write(text + "\n")
        answers.flush()
        if stop:
            return
