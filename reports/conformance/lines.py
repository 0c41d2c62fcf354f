"""A run as JSON lines: settings, all findings, shrunk findings, and the end."""

from __future__ import annotations

import json
from typing import Any


def json_lines(value: dict[str, Any]) -> str:
    """JSON objects, each on its own line and with its kind under `is`: `run`, `finding` and
    `shrunk` as the run's document has them, then `end`."""
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
