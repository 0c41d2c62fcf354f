"""The adapters of tests/page_alone, written from the page of the protocol alone, as targets."""

from __future__ import annotations

import importlib
import sys
from pathlib import Path
from typing import Any

FOLDER = Path(__file__).resolve().parents[3] / "tests" / "page_alone"


def kinds(which: str) -> dict[str, Any]:
    """By name, with the class of each: the UNUSUAL, which are right, or the FAULTY."""
    if str(FOLDER) not in sys.path:
        sys.path.insert(0, str(FOLDER))
    found: dict[str, Any] = getattr(importlib.import_module("catalogue"), which)
    return found


def target_of(name: str) -> str:
    return f"cmd:{sys.executable} {FOLDER / 'adapter.py'} {name}"
