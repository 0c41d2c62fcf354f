"""A run as JSON lines: what was run, all findings, the shrunk ones, and how it ended."""

from __future__ import annotations

import json
from typing import Any


def json_lines(value: dict[str, Any]) -> str:
    """One object a line, its kind in `is`: `run`, `finding` and `shrunk` as in the document of the
    run, then `end`."""
    start = {
        "is": "run",
        "version": value["version"],
        "seed": value["seed"],
        "targets": value["targets"],
        "groups": value["groups"],
    }
    rows = [{**finding, "is": "finding"} for finding in value["findings"]]
    rows += [{**finding, "is": "shrunk"} for finding in value["shrunk"]]
    end = {
        "is": "end",
        "exit_code": value["exit_code"],
        "findings": len(value["findings"]),
        "shrunk": len(value["shrunk"]),
    }
    return "".join(json.dumps(row, separators=(",", ":")) + "\n" for row in (start, *rows, end))
