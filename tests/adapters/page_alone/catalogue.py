"""This folder's adapters by name."""

from __future__ import annotations

from types import ModuleType

import faulty_events
import faulty_holes
import faulty_numbers
import faulty_space
import faulty_space_verbs
import faulty_talk
import unusual_numbers
import unusual_rings
import unusual_space
import unusual_space_sums
import unusual_talk
import unusual_verbs
from conversation import Adapter

BASES = ("FaultyInSpace", "FlatEverything")


def of_modules(*modules: ModuleType) -> dict[str, type[Adapter]]:
    """The adapters that the modules define."""
    return {
        name: kind
        for module in modules
        for name, kind in vars(module).items()
        if isinstance(kind, type) and issubclass(kind, Adapter)
        if kind.__module__ == module.__name__ and name not in BASES
    }


UNUSUAL = of_modules(
    unusual_rings, unusual_numbers, unusual_verbs, unusual_talk, unusual_space, unusual_space_sums
)
FAULTY = of_modules(
    faulty_holes, faulty_numbers, faulty_events, faulty_talk, faulty_space, faulty_space_verbs
)
ADAPTERS = {**UNUSUAL, **FAULTY}
