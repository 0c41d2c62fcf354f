"""Targets to test: our own routes and judges, the methods of CGAL, adapters, functions."""

from __future__ import annotations

import subprocess
from dataclasses import dataclass
from pathlib import Path

from minkref.errors import Refusal, nearest
from minkref.fuzz.cgal.executables import (
    ABOUT,
    cgal_version,
    executable_of_target,
    method_of_target,
    refuse_wrong_folder,
    target_names,
)
from minkref.fuzz.judges import checks
from minkref.fuzz.libraries import catalogue as adapters
from minkref.fuzz.plane.cgal_method import CgalMethod
from minkref.fuzz.plane.reference import ROUTES, ReferenceTarget
from minkref.fuzz.space.convex_reference import CONVEX_ROUTES, ConvexReferenceTarget
from minkref.fuzz.space.space_reference import SPACE_ROUTES, SpaceReferenceTarget
from minkref.fuzz.targets.adapter import AdapterTarget
from minkref.fuzz.targets.adapter_process import named_command
from minkref.fuzz.targets.answer import REFERENCE, Limits, Target
from minkref.fuzz.targets.function import FunctionTarget, host_command
from minkref.version import version


@dataclass(frozen=True)
class TargetEntry:
    name: str
    version: str | None
    about: str
    available: bool
    reason: str | None = None


def list_targets() -> list[TargetEntry]:
    """Lists all targets that this machine could test; absent targets say how to get them."""
    refuse_wrong_folder()
    ours = [
        TargetEntry(f"{REFERENCE}{route}", version(), about, True)
        for route, about in (ROUTES | CONVEX_ROUTES | SPACE_ROUTES).items()
    ]
    judged = [TargetEntry(checks.ALL, version(), "the reference before every judge", True)]
    for name, (_, about) in checks.MODULES.items():
        reason = checks.absence(name)
        judged.append(
            TargetEntry(f"{checks.PREFIX}{name}", version(), about, reason is None, reason)
        )
    programs = [_adapter_entry(name) for name in adapters.ADAPTERS]
    return ours + judged + [_cgal_entry(name) for name in target_names()] + programs


def _cgal_entry(name: str) -> TargetEntry:
    method, raw = method_of_target(name)
    about = ABOUT[method] + (", holes as given" if raw else "")
    try:
        return TargetEntry(name, cgal_version(method, executable_of_target(name)), about, True)
    except (OSError, subprocess.SubprocessError, ValueError, KeyError) as error:
        return TargetEntry(name, None, about, False, str(error))


def _adapter_entry(name: str) -> TargetEntry:
    entry = adapters.ADAPTERS[name]
    reason = adapters.absence(name)
    return TargetEntry(name, None, entry.title, reason is None, reason)


def select(names: list[str]) -> tuple[list[TargetEntry], list[TargetEntry]]:
    """Returns the targets to run, and the absent targets. Without names: our routes and all CGAL
    methods except raw ones; `minkref` means every judge, `all` everything found here. Refuses an
    unknown or absent name."""
    entries = {entry.name: entry for entry in list_targets()}
    plain = [
        entry
        for entry in entries.values()
        if entry.name != checks.ALL and not entry.name.startswith(checks.PREFIX)
    ]
    if not names:
        wanted = [e for e in plain if "-raw" not in e.name and is_default(e.name)]
        return [e for e in wanted if e.available], [e for e in wanted if not e.available]
    groups = {
        checks.ALL: [entries[name] for name in checks.names()],
        "all": [e for e in plain if "-raw" not in e.name],
    }
    chosen: list[TargetEntry] = []
    absent: list[TargetEntry] = []
    for name in dict.fromkeys(names):
        if name in groups:
            chosen += [e for e in groups[name] if e.available]
            absent += [e for e in groups[name] if not e.available]
        elif is_function(name):
            host_command(name)
            about = "a C function" if name.startswith("so:") else "a Python function"
            chosen.append(TargetEntry(name, None, about, True))
        elif is_program(name):
            chosen.append(_named_adapter(name))
        elif name not in entries:
            raise Refusal("there is no such target", name, _mend(name, [*entries, *groups]))
        elif not entries[name].available:
            raise Refusal(
                f"this target is absent: {entries[name].reason}", name, "install it as said"
            )
        else:
            chosen.append(entries[name])
    return list({entry.name: entry for entry in chosen}.values()), absent


def select_one(name: str) -> TargetEntry:
    """Returns the target with this name. Refuses a name for several."""
    chosen, _ = select([name])
    if len(chosen) != 1:
        what = f"this stands for {len(chosen)} targets"
        raise Refusal(what, name, "name one of `minkref targets`")
    return chosen[0]


def _mend(name: str, known: list[str]) -> str:
    """Advice for an unknown target name, which perhaps names a file."""
    if Path(name).is_file():
        return f"write ./{name} for the program of this name"
    return f"{nearest(name, known)}`minkref targets` lists them"


def _named_adapter(name: str) -> TargetEntry:
    named_command(name)
    return TargetEntry(name, None, "an adapter", True)


def is_default(name: str) -> bool:
    """Whether a run without names takes the target: in the plane all of CGAL, and our routes."""
    if name.removeprefix(REFERENCE) in CONVEX_ROUTES | SPACE_ROUTES:
        return False
    return name.startswith((REFERENCE, "cgal-")) and name not in adapters.ADAPTERS


def is_function(name: str) -> bool:
    return name.startswith(("py:", "so:"))


def is_program(name: str) -> bool:
    return name.startswith("cmd:") or ("/" in name and not is_function(name))


def is_adapter(name: str) -> bool:
    return is_program(name) or name in adapters.ADAPTERS


def declares_itself(name: str) -> bool:
    """Whether the name means a foreign program or function, which declares its own capabilities."""
    return is_adapter(name) or is_function(name)


def make_target(name: str, limits: Limits) -> Target:
    if name.startswith(REFERENCE):
        route = name.removeprefix(REFERENCE)
        if route in CONVEX_ROUTES:
            return ConvexReferenceTarget(name, route)
        if route in SPACE_ROUTES:
            return SpaceReferenceTarget(name, route)
        return ReferenceTarget(name, route)
    if is_function(name):
        return FunctionTarget(name, host_command(name), limits)
    if is_program(name):
        return AdapterTarget(name, named_command(name), limits)
    if name in adapters.ADAPTERS:
        command = adapters.command(name)
        if command is None:
            raise Refusal(f"this target is absent: {adapters.absence(name)}", name, "install it")
        return AdapterTarget(name, command, limits)
    return CgalMethod(name, limits)
