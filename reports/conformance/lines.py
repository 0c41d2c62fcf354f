"""The findings as JSON lines: the shrunk ones where there are such, else all."""

from __future__ import annotations

import json
from typing import Any


def json_lines(value: dict[str, Any]) -> str:
    """One object a line, as in the document of the run; then one with the totals."""
    rows = [{"is": "finding", **finding} for finding in value["findings"]]
    rows += [{"is": "shrunk", **finding} for finding in value["shrunk"]]
    end = {"is": "end", "exit_code": value["exit_code"], "findings": len(value["findings"])}
    return "".join(json.dumps(row, separators=(",", ":")) + "\n" for row in (*rows, end))
