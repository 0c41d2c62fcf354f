"""What can be tested: our own routes, the methods of CGAL, and Python callables."""

from __future__ import annotations

import importlib
import json
import subprocess
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol, cast

from minkref import _core
from minkref.errors import Refusal, message_of
from minkref.fuzz.cases.case import Case
from minkref.fuzz.cgal.executables import (
    ABOUT,
    cgal_version,
    method_of_target,
    refuse_wrong_folder,
    target_names,
)
from minkref.fuzz.cgal.oracle import CgalOracle
from minkref.fuzz.judges import checks
from minkref.fuzz.verdicts.region import Region, plain_polygons, region_of_polygons, region_of_sum
from minkref.fuzz.verdicts.verdict import Verdict
from minkref.version import version

ROUTES = {
    "paper": "reduced convolution, orientable loops, nesting, collision detection",
    "winding": "winding number of the full convolution of slit operands",
    "definition": "union of the sums of all pairs of triangles",
}
# m n above which a slow target skips a case (the option --size-limit replaces it).
SIZE_LIMITS = {"minkref:definition": 7_000}
SLOW_CGAL_LIMIT = 10_000
LOAD_SECONDS = 60.0  # at least, for the import of the module of a `py:` target
FAST_CGAL = ("cgal-reduced", "cgal-reduced-raw")


@dataclass(frozen=True)
class Limits:
    """For one call of one target."""

    seconds: float = 30.0
    bytes: int = 4 << 30
    size: int | None = None


@dataclass
class Answer:
    """What a target said: a region, or a verdict that says why there is none."""

    region: Region | None = None
    verdict: Verdict | None = None
    message: str = ""
    signal: str | None = None
    seconds: float = 0.0


class Target(Protocol):
    name: str

    def sum(self, case: Case) -> Answer: ...

    def close(self) -> None: ...


@dataclass
class ReferenceTarget:
    name: str
    route: str

    def sum(self, case: Case) -> Answer:
        try:
            answer = _core.minkowski_sum(case.P, case.Q, case.scale, self.route, "rational")
        except MemoryError as error:
            return Answer(verdict=Verdict.OUT_OF_MEMORY, message=str(error))
        except Exception as error:  # noqa: BLE001 a fault of the target, whatever it is
            return Answer(verdict=Verdict.ERRORED, message=message_of(error))
        return Answer(region_of_sum(answer), seconds=answer.seconds)

    def close(self) -> None:
        pass


class CgalTarget:
    """A method of CGAL, each call in a child process of the oracle's server."""

    def __init__(self, name: str, limits: Limits) -> None:
        self.name = name
        method, raw = method_of_target(name)
        self._oracle = CgalOracle(method, raw=raw, seconds=limits.seconds, bytes=limits.bytes)

    def sum(self, case: Case) -> Answer:
        answer = self._oracle.sum(case.scaled_P_json, case.Q_json)
        if answer.status != "result":
            return Answer(
                verdict=Verdict(answer.status),
                message=answer.reason or "",
                signal=answer.signal,
                seconds=answer.seconds or 0.0,
            )
        return answered(answer.rings_json or "", answer.seconds or 0.0)

    def close(self) -> None:
        self._oracle.close()


class CallableTarget:
    """`py:module:function`. The function takes sP and Q as dictionaries in the form of the
    canonical JSON (not necessarily canonical) and returns their sum in the same form, its numbers
    as texts `n` or `n/d` or as int, its rings running either way; None says that the case is
    outside its capabilities."""

    def __init__(self, name: str) -> None:
        self.name = name
        self._function = load_function(name)

    def sum(self, case: Case) -> Answer:
        try:
            result = self._function(json.loads(case.scaled_P_json), json.loads(case.Q_json))
        except MemoryError as error:
            return Answer(verdict=Verdict.OUT_OF_MEMORY, message=message_of(error))
        except BaseException as error:  # noqa: BLE001 a fault of the target, whatever it is
            return Answer(verdict=Verdict.ERRORED, message=message_of(error))
        if result is None:
            return Answer(verdict=Verdict.SKIPPED, message="outside the capabilities of the target")
        return answered(result, 0.0, turned=True)

    def close(self) -> None:
        pass


@dataclass
class _UnloadableTarget:
    """A function that could be loaded before the run, and now cannot."""

    name: str
    message: str

    def sum(self, case: Case) -> Answer:
        return Answer(verdict=Verdict.ERRORED, message=self.message)

    def close(self) -> None:
        pass


def load_function(name: str) -> Callable[[Any, Any], Any]:
    """The function of `py:module:function`. Raises what the import of the module raises."""
    _, module, function = name.split(":", 2)
    loaded = getattr(importlib.import_module(module), function)
    if not callable(loaded):
        raise TypeError(f"{function} is no function")
    return cast(Callable[[Any, Any], Any], loaded)


def answered(rings: Any, seconds: float, turned: bool = False) -> Answer:
    """The answer of somebody else, put into canonical form. `turned`: its rings may run either way
    and are turned as their role demands."""
    try:
        plain = plain_polygons(json.loads(rings) if isinstance(rings, str) else rings)
    except MemoryError as error:
        return Answer(verdict=Verdict.OUT_OF_MEMORY, message=message_of(error), seconds=seconds)
    except Exception as error:  # noqa: BLE001 the objects of somebody else may do anything
        return _no_set(error, seconds)
    try:
        return Answer(region_of_polygons(plain, turned), seconds=seconds)
    except ValueError as error:
        return _no_set(error, seconds)


def _no_set(error: Exception, seconds: float) -> Answer:
    message = f"the answer is not a polygon set: {message_of(error)}"
    return Answer(verdict=Verdict.ERRORED, message=message, seconds=seconds)


@dataclass(frozen=True)
class TargetEntry:
    name: str
    version: str | None
    about: str
    available: bool
    reason: str | None = None


def list_targets() -> list[TargetEntry]:
    """All that this machine could test; what is absent says how to get it."""
    refuse_wrong_folder()
    ours = [
        TargetEntry(f"minkref:{route}", version(), about, True) for route, about in ROUTES.items()
    ]
    judged = [TargetEntry(checks.ALL, version(), "the reference before every judge", True)]
    for name, (_, about) in checks.MODULES.items():
        reason = checks.absence(name)
        judged.append(
            TargetEntry(f"{checks.PREFIX}{name}", version(), about, reason is None, reason)
        )
    return ours + judged + [_cgal_entry(name) for name in target_names()]


def _cgal_entry(name: str) -> TargetEntry:
    method, raw = method_of_target(name)
    about = ABOUT[method] + (", holes as given" if raw else "")
    try:
        return TargetEntry(name, cgal_version(method), about, True)
    except (OSError, subprocess.SubprocessError, ValueError, KeyError) as error:
        return TargetEntry(name, None, about, False, str(error))


def select(
    names: list[str], load_seconds: float = LOAD_SECONDS
) -> tuple[list[TargetEntry], list[TargetEntry]]:
    """The targets to run, and those that are absent. Without names: all but the raw ones and the
    judges; `minkref` stands for every judge. A name
    that is unknown or absent is refused, as is a `py:` target that is not loaded in
    `load_seconds`."""
    from minkref.fuzz.targets.callable_check import refuse_unless_callable

    entries = {entry.name: entry for entry in list_targets()}
    if not names:
        wanted = [
            entry
            for entry in entries.values()
            if not entry.name.endswith("-raw")
            and entry.name != checks.ALL
            and not entry.name.startswith(checks.PREFIX)
        ]
        return [e for e in wanted if e.available], [e for e in wanted if not e.available]
    chosen: list[TargetEntry] = []
    absent: list[TargetEntry] = []
    if checks.ALL in names:
        judges = [entries[name] for name in checks.names()]
        absent = [entry for entry in judges if not entry.available]
        names = [
            each
            for name in names
            for each in ([e.name for e in judges if e.available] if name == checks.ALL else [name])
        ]
    for name in dict.fromkeys(names):
        if name.startswith("py:"):
            refuse_unless_callable(name, load_seconds)
            chosen.append(TargetEntry(name, None, "a Python function", True))
        elif name not in entries:
            raise Refusal("there is no such target", name, "`minkref targets` lists them")
        elif not entries[name].available:
            raise Refusal(
                f"this target is absent: {entries[name].reason}", name, "build it as said"
            )
        else:
            chosen.append(entries[name])
    return chosen, absent


def make_target(name: str, limits: Limits) -> Target:
    if name.startswith("minkref:"):
        return ReferenceTarget(name, name.removeprefix("minkref:"))
    if name.startswith("py:"):
        return _callable_target(name)
    return CgalTarget(name, limits)


def _callable_target(name: str) -> Target:
    try:
        return CallableTarget(name)
    except BaseException as error:  # noqa: BLE001 a module may do anything on import
        return _UnloadableTarget(name, message_of(error))


def size_limit(name: str, limits: Limits) -> int | None:
    """m n above which the target skips a case; None where it takes any size."""
    slow_cgal = name.startswith("cgal-") and name not in FAST_CGAL
    default = SIZE_LIMITS.get(name, SLOW_CGAL_LIMIT if slow_cgal else None)
    return limits.size if default is not None and limits.size is not None else default
