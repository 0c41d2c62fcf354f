"""Reads a campaign's TOML file."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Annotated, Any, Literal

import msgspec
from minkref.errors import Refusal, cut
from minkref.file_text import text_of_file
from minkref.fuzz.shrink.shrinker import MOST_CALLS
from minkref.fuzz.targets.answer import JUDGING_BYTES, PROCESSES
from msgspec import Meta

SettingName = Literal["plane", "disc", "space", "motion", "scene"]
LARGEST_SEED = 2**63 - 1
Some = Annotated[int, Meta(ge=1)]
MEND = "docs/campaigns.md lists the keys"
GIVE = "give a file as docs/campaigns.md begins with: minkref campaign run FILE.toml"


class Table(msgspec.Struct, forbid_unknown_fields=True, rename="kebab", frozen=True):
    """A table without unknown keys; `-` in a key stands for `_`."""


class Budget(Table, frozen=True):
    """Ends a campaign; `seconds` and `hours` add up over its runs."""

    cases: Some | None = None
    seconds: Annotated[float, Meta(gt=0)] | None = None
    hours: Annotated[float, Meta(gt=0)] | None = None

    @property
    def time(self) -> float | None:
        """Returns seconds, or None without a limit."""
        if self.seconds is None and self.hours is None:
            return None
        return (self.seconds or 0.0) + 3600 * (self.hours or 0.0)


class CallLimits(Table, frozen=True):
    """Limits for each call, as options of `minkref verify`; memory and output in MiB."""

    call_seconds: Annotated[float, Meta(gt=0, le=86_400)] = 30.0
    call_memory: Annotated[int, Meta(ge=16, le=1 << 24)] = 4096
    call_output: Annotated[int, Meta(ge=1, le=1 << 24)] = 64
    call_processes: Annotated[int, Meta(ge=1, le=1 << 20)] = PROCESSES
    memory: Annotated[int, Meta(ge=256, le=1 << 24)] = JUDGING_BYTES >> 20
    size_limit: Some | None = None


class ClusterTable(Table, frozen=True):
    """Says where workers run. `options` and `adapt` reach the cluster's class unchanged."""

    kind: str = "local"
    workers: Some | None = None
    adapt: dict[str, Any] = {}
    options: dict[str, Any] = {}


class CampaignFile(Table, frozen=True):
    """`chunk`: about how many cases a worker gets at a time."""

    targets: Annotated[list[str], Meta(min_length=1)]
    name: str = ""
    seed: Annotated[int, Meta(ge=-LARGEST_SEED, le=LARGEST_SEED)] = 1
    settings: list[SettingName] = []
    families: list[str] = []
    derived: bool = True
    chunk: Annotated[int, Meta(ge=1, le=100_000)] = 200
    shrink_calls: Annotated[int, Meta(ge=0)] = MOST_CALLS
    baseline: str | None = None
    isolation: str = "auto"
    pass_env: list[str] = []
    budget: Budget = Budget()
    limits: CallLimits = CallLimits()
    cluster: ClusterTable = ClusterTable()


def read_campaign(path: Path) -> CampaignFile:
    """Reads a file. Refuses unknown keys and wrong kinds of values, with their place."""
    text = text_of_file(path, str(path), GIVE)
    try:
        value = tomllib.loads(text)
    except (ValueError, RecursionError) as error:
        what = f"this is no TOML: {cut(str(error))}"
        raise Refusal(what, str(path), GIVE, "campaign") from error
    try:
        return msgspec.convert(value, CampaignFile)
    except msgspec.ValidationError as error:
        what, _, place = str(error).partition(" - at `$.")
        where = f"{path}, {place.rstrip('`')}" if place else str(path)
        raise Refusal(what, where, MEND, "campaign") from error
