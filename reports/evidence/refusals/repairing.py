"""Run `minkref repair` twice within this process, the second time on the repaired file."""

from __future__ import annotations

import io
import json
from collections.abc import Sequence
from contextlib import redirect_stdout
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any

from minkref.cli.command_group import load


@dataclass(frozen=True)
class Repair:
    """The changes, the text written, and the changes of the second repair."""

    changes: list[dict[str, Any]]
    output: str
    again: list[dict[str, Any]]


def repair(file: Path, output: Path, rule: str, weld: Fraction | None) -> Repair:
    options = ["--rule", rule, *([] if weld is None else ["--weld", str(weld)])]
    first = _document([str(file), *options, "-o", str(output)])
    text = output.read_text(encoding="utf-8")
    return Repair(first["changes"], text, _document([str(output), *options])["changes"])


def _document(arguments: Sequence[str]) -> dict[str, Any]:
    told = io.StringIO()
    with redirect_stdout(told):
        load("repair").main([*arguments, "--json"], standalone_mode=False)
    document: dict[str, Any] = json.loads(told.getvalue())
    return document
