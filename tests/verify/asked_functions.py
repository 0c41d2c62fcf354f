"""Functions that answer a union, an offset and features: `py:asked_functions:NAME`."""

from __future__ import annotations

import json
from pathlib import Path
from sys import path
from typing import Any

import minkref

path.insert(0, str(Path(__file__).parent))
import features_adapter
from offset_adapter import ALL, answer_to, read

ABLE = [word for word in ALL if word not in ("offset", "point", "segment")]


def united(sets: list[Any]) -> Any:
    return json.loads(minkref.write(minkref.unite([read(each) for each in sets]), "json"))


def grown(P: Any, radius: str) -> Any:
    return answer_to("polygon", {"P": P, "radius": radius})


def without_holes(P: Any, radius: str) -> Any:
    return answer_to("lost-hole", {"P": P, "radius": radius})


def curves(P: Any, radius: str) -> Any:
    return answer_to("curves", {"P": P, "radius": radius})


def bars(P: Any, radius: str) -> Any:
    return features_adapter.answer_to("right", {"P": P, "radius": radius})


bars.minkref = {"sum": "none", "capabilities": features_adapter.ALL}  # type: ignore[attr-defined]
NEAR = {"arithmetic": "polygons", "tolerance": {"radius": "0.0022", "relative": "1e-12"}}
united.minkref = {"sum": "none", "capabilities": [*ABLE, "union"]}  # type: ignore[attr-defined]
curves.minkref = {"sum": "none", "capabilities": ALL}  # type: ignore[attr-defined]
for function in (grown, without_holes):
    function.minkref = {**NEAR, **curves.minkref}  # type: ignore[attr-defined]
