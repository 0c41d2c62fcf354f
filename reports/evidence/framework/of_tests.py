"""Adapters, functions and faults that folders of tests/ hold, as targets and as modules."""

from __future__ import annotations

import importlib
import sys
from pathlib import Path
from typing import Any

from minkref.reports.evidence.framework.places import ROOT

SEEDED = ROOT / "tests" / "adapters" / "seeded"  # a small implementation, and faults to put into it
SEEDED_OFFSETS = SEEDED.with_name("seeded_offsets")  # the same for the verb `offset`
PAGE_ALONE = SEEDED.with_name("page_alone")  # adapters written from the page of the protocol alone
VERIFY = ROOT / "tests" / "verify"  # adapters with planted faults


def module(name: str, *folders: Path) -> Any:
    """A test module whose own imports lie in these folders."""
    for folder in folders:
        if str(folder) not in sys.path:
            sys.path.insert(0, str(folder))
    return importlib.import_module(name)


def seeded_faults() -> dict[str, Any]:
    """By name."""
    found: dict[str, Any] = module("seeded_sums", SEEDED).FAULTS
    return found


def losing_a_hole() -> str:
    """The first seeded fault about holes that functions show as well as adapters."""
    faults = seeded_faults()
    return next(name for name in sorted(faults) if "hole" in name and not faults[name].needs_scale)


def path_adapter(way: str) -> str:
    """The target name for an adapter that answers the verb `path`."""
    return f"cmd:{sys.executable} {VERIFY / 'path_adapter.py'} {way}"


def union_adapter(way: str) -> str:
    """The target name for an adapter that unites sets."""
    return f"cmd:{sys.executable} {VERIFY / 'union_adapter.py'} {way}"


def offset_adapter(way: str) -> str:
    """The target name for an adapter that grows sets by a disc."""
    return f"cmd:{sys.executable} {VERIFY / 'offset_adapter.py'} {way}"


def features_adapter(way: str) -> str:
    """The target name for an adapter that finds concave features."""
    return f"cmd:{sys.executable} {VERIFY / 'features_adapter.py'} {way}"


def seeded_adapter(fault: str) -> str:
    """The target; `sound` for none."""
    return f"cmd:{sys.executable} {SEEDED / 'seeded_adapter.py'} {fault}"


def seeded_offset(name: str) -> str:
    """The target for a fault of the verb `offset`; 0 for none."""
    return f"cmd:{sys.executable} {SEEDED_OFFSETS / 'seeded_offset.py'} {name}"


def page_adapters(which: str) -> dict[str, Any]:
    """Adapter classes by name: the UNUSUAL adapters, all right, or the FAULTY ones."""
    found: dict[str, Any] = getattr(module("catalogue", PAGE_ALONE), which)
    return found


def page_adapter(name: str) -> str:
    """The target."""
    return f"cmd:{sys.executable} {PAGE_ALONE / 'adapter.py'} {name}"
