"""All adapters of this folder by name."""

from __future__ import annotations

from types import ModuleType

import faulty_plane
import faulty_space
import faulty_verbs
import unusual_plane
import unusual_space
from conversation import Adapter

BASES = ("Faulty", "FaultyInSpace")


def of_modules(*modules: ModuleType) -> dict[str, type[Adapter]]:
    """Those that the modules define."""
    return {
        name: kind
        for module in modules
        for name, kind in vars(module).items()
        if isinstance(kind, type) and issubclass(kind, Adapter)
        if kind.__module__ == module.__name__ and name not in BASES
    }


UNUSUAL = of_modules(unusual_plane, unusual_space)
FAULTY = of_modules(faulty_plane, faulty_verbs, faulty_space)
ADAPTERS = {**UNUSUAL, **FAULTY}
