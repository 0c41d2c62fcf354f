"""The folders of the evidence and of its results."""

from __future__ import annotations

import os
from pathlib import Path

ROOM = Path(__file__).resolve().parents[1]
ROOT = ROOM.parents[1]
FOLDER = Path(os.environ.get("MINKREF_EVIDENCE") or ROOT / "build" / "evidence")
