"""The adapters of libraries, as targets of a run."""

from __future__ import annotations

from minkref.errors import Refusal
from minkref.fuzz.libraries.catalogue import (
    ADAPTERS,
    absence,
    adapter_named,
    command,
    in_all,
    is_named,
)
from minkref.fuzz.run.offer import Offer
from minkref.fuzz.targets.adapter import AdapterTarget
from minkref.fuzz.targets.answer import Limits


def _target(name: str, limits: Limits) -> AdapterTarget:
    words = command(name)
    if words is None:
        raise Refusal(f"this target is absent: {absence(name)}", name, "install it")
    return AdapterTarget(name, words, limits)


def _title(name: str) -> str | None:
    return adapter_named(name).title if is_named(name) else None


OFFER = Offer(
    {name: adapter.title for name, adapter in ADAPTERS.items()}, absence, _target, _title, in_all
)
