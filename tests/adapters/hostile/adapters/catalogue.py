"""All hostile adapters by name."""

from __future__ import annotations

import declarations
import endings
import floods
import folders
import forgeries
import memory
import processes
import reach
import spellings
from honest import Adapter

MODULES = (
    *(processes, forgeries, floods, spellings, declarations, reach, folders, memory, endings),
)
ADAPTERS: dict[str, type[Adapter]] = {
    name: kind
    for module in MODULES
    for name, kind in vars(module).items()
    if isinstance(kind, type) and issubclass(kind, Adapter) and kind.__module__ == module.__name__
}
