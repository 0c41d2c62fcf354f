"""The request of `minkref campaign run`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class CampaignRequest:
    """The options of a run."""

    file: Path
    output: Path | None
    workers: int | None
    scheduler: str | None
    cases: int | None
    seconds: float | None
    share: str
    site: Path | None
    strict: bool
    quiet: bool
    json: bool
