"""Client of the CGAL oracle: sums by CGAL's methods, each computed in a child process of a server.

The servers are the executables in oracle/cgal (GPL-3.0-or-later); they speak JSON lines, as their
README.md says. Damage that CGAL does to its own process never reaches this process.
"""

from __future__ import annotations

import json
import os
import signal as signals
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from minkref.fuzz.cgal.executables import (
    ABOUT,
    BUILD_COMMAND,
    METHOD_GROUPS,
    METHODS_WITH_HOLES,
    OracleNotFoundError,
    available_targets,
    cgal_version,
    find_executable,
    method_of_target,
    target_names,
)
from minkref.fuzz.cgal.server import OracleServer

__all__ = [
    "ABOUT",
    "BUILD_COMMAND",
    "METHODS_WITH_HOLES",
    "METHOD_GROUPS",
    "CgalOracle",
    "OracleAnswer",
    "OracleNotFoundError",
    "available_targets",
    "cgal_version",
    "find_executable",
    "method_of_target",
    "target_names",
]


@dataclass(frozen=True)
class OracleAnswer:
    """A call's outcome. `seconds` is the CGAL call's own time if a result exists, else the time
    until the call ended; `total_seconds` is the child process's time. `rings_json` is the result as
    CGAL gave it, `{"polygons":[...]}`, not canonical. `signal` is a name, as SIGSEGV; a crash
    without a name is a std::bad_alloc that no limit of ours explains."""

    status: str
    reason: str | None = None
    rings_json: str | None = None
    seconds: float | None = None
    signal: str | None = None
    total_seconds: float | None = None
    peak_bytes: int | None = None
    removed_holes: int = 0


class CgalOracle(OracleServer):
    """Computes sums by a CGAL method. `raw` passes every hole to CGAL, also holes that cannot
    survive and over which CGAL 5.5.1 may corrupt its memory. `seconds` and `bytes` limit each
    call."""

    def __init__(
        self,
        method: str,
        executable: str | os.PathLike[str] | None = None,
        raw: bool = False,
        seconds: float = 60.0,
        bytes: int = 4 << 30,
    ) -> None:
        if method not in METHOD_GROUPS and not method.startswith("self-test:"):
            raise ValueError(f"no method {method!r}; there are {', '.join(METHOD_GROUPS)}")
        self.method = method
        self.raw = raw
        known = method if method in METHOD_GROUPS else "reduced"
        super().__init__(Path(executable) if executable else find_executable(known), seconds, bytes)

    def sum(self, P_json: str | dict[str, Any], Q_json: str | dict[str, Any]) -> OracleAnswer:
        """Sums two polygon sets {"polygons":[{"outer":[["x","y"],...],"holes":[...]}]}. Every
        failure of CGAL or of the server becomes an answer; OSError if no server starts."""
        value = self.ask(self.method, {"P": P_json, "Q": Q_json}, raw=self.raw)
        try:
            signal = value.get("signal")
            result = value.get("result")
            return OracleAnswer(
                status=value["status"],
                reason=value.get("reason"),
                rings_json=json.dumps(result, separators=(",", ":")) if result else None,
                seconds=value.get("seconds"),
                signal=signals.Signals(signal).name if signal else None,
                total_seconds=value.get("total_seconds"),
                peak_bytes=value.get("peak_bytes"),
                removed_holes=value.get("removed_holes", 0),
            )
        except (ValueError, TypeError) as error:
            lost = self.lost(f"the server's answer is not that of the protocol: {error}")
            return OracleAnswer(status=lost["status"], reason=lost["reason"])
