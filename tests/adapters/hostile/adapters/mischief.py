"""The hostile adapters as functions: `py:mischief:NAME` does the mischief of the adapter NAME when
it is loaded or called. MINKREF_HOSTILE holds the adapter's options, as JSON."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from typing import Any

from bounds import bind
from catalogue import ADAPTERS
from honest import Adapter, Request

Set = dict[str, Any]


def __getattr__(name: str) -> Callable[[Set, Set], Any]:
    if name not in ADAPTERS:
        raise AttributeError(name)
    bind()
    adapter = ADAPTERS[name](json.loads(os.environ["MINKREF_HOSTILE"]))
    hello = adapter.answer({"seq": 1, "verb": "hello"})

    def function(sP: Set, Q: Set) -> Any:
        return answered(adapter, {"seq": 2, "verb": "at", "scale": "1", "sP": sP}, Q)

    function.minkref = {  # type: ignore[attr-defined]
        word: value for word, value in hello.items() if word not in ("seq", "status", "protocol")
    }
    return function


def answered(adapter: Adapter, request: Request, Q: Set) -> Any:
    adapter.load({"seq": 2, "verb": "load", "dimension": 2, "P": Q, "Q": Q})
    if adapter.instead:
        adapter.mischief(request)
    answer = adapter.at(request)
    if answer["status"] != "result":
        raise RuntimeError(answer.get("reason"))
    return answer
