"""Targets to test: our own routes, the methods of CGAL, adapters, functions, and what judges and
libraries offer."""

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
from minkref.fuzz.plane.cgal_method import CgalMethod
from minkref.fuzz.plane.reference import ROUTES, ReferenceTarget
from minkref.fuzz.run.offer import Judge, Offer
from minkref.fuzz.space.convex_reference import CONVEX_ROUTES, ConvexReferenceTarget
from minkref.fuzz.space.space_reference import SPACE_ROUTES, SpaceReferenceTarget
from minkref.fuzz.targets.adapter import AdapterTarget
from minkref.fuzz.targets.adapter_process import named_command
from minkref.fuzz.targets.answer import JUDGED, REFERENCE, Limits, Target
from minkref.fuzz.targets.function import FunctionTarget, host_command
from minkref.version import version

EVERY_JUDGE = "minkref"


@dataclass(frozen=True)
class TargetEntry:
    name: str
    version: str | None
    about: str
    available: bool
    reason: str | None = None


@dataclass(frozen=True)
class Catalogue:
    """Targets by name. `judges` and `adapters` come from floors above the run; a worker gets them
    at its start."""

    judges: Offer[Judge]
    adapters: Offer[Target]

    def entries(self) -> list[TargetEntry]:
        """Lists all targets that this machine could test; absent targets say how to get them."""
        refuse_wrong_folder()
        ours = [
            TargetEntry(f"{REFERENCE}{route}", version(), about, True)
            for route, about in (ROUTES | CONVEX_ROUTES | SPACE_ROUTES).items()
        ]
        every = TargetEntry(EVERY_JUDGE, version(), "the reference before every judge", True)
        judged = [every, *_offered(self.judges, version())]
        cgal = [_cgal_entry(name) for name in target_names()]
        return [*ours, *judged, *cgal, *_offered(self.adapters, None)]

    def select(self, names: list[str]) -> tuple[list[TargetEntry], list[TargetEntry]]:
        """Returns the targets to run, and the absent targets. Without names: our routes and all
        CGAL methods except raw ones; `minkref` means every judge, `all` everything found here.
        Refuses an unknown or absent name."""
        entries = {entry.name: entry for entry in self.entries()}
        plain = [
            entry
            for entry in entries.values()
            if entry.name != EVERY_JUDGE and entry.name not in self.judges.about
        ]
        if not names:
            wanted = [e for e in plain if "-raw" not in e.name and self._is_default(e.name)]
            return [e for e in wanted if e.available], [e for e in wanted if not e.available]
        groups = {
            EVERY_JUDGE: [entries[name] for name in self.judges.about],
            "all": [e for e in plain if "-raw" not in e.name and self._is_in_all(e.name)],
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
            elif name not in entries and self.adapters.has(name):
                about = self.adapters.title(name) or ""
                chosen.append(TargetEntry(name, version(), about, True))
            elif name not in entries:
                raise Refusal("there is no such target", name, _mend(name, [*entries, *groups]))
            elif not entries[name].available:
                raise Refusal(
                    f"this target is absent: {entries[name].reason}", name, "install it as said"
                )
            else:
                chosen.append(entries[name])
        return list({entry.name: entry for entry in chosen}.values()), absent

    def select_one(self, name: str) -> TargetEntry:
        """Returns the target with this name. Refuses a name for several."""
        chosen, _ = self.select([name])
        if len(chosen) != 1:
            what = f"this stands for {len(chosen)} targets"
            raise Refusal(what, name, "name one of `minkref targets`")
        return chosen[0]

    def _is_default(self, name: str) -> bool:
        """Whether a run without names takes the target: in the plane all of CGAL, and our
        routes."""
        if name.removeprefix(REFERENCE) in CONVEX_ROUTES | SPACE_ROUTES:
            return False
        return name.startswith((REFERENCE, "cgal-")) and name not in self.adapters.about

    def _is_in_all(self, name: str) -> bool:
        return name not in self.adapters.about or self.adapters.in_all(name)

    def declares_itself(self, name: str) -> bool:
        """Whether the name means a foreign program or function, which declares its own
        capabilities."""
        return is_program(name) or is_function(name) or self.adapters.has(name)

    def target(self, name: str, limits: Limits) -> Target:
        """Makes the target with this name, which is no judge."""
        if name.startswith(REFERENCE):
            return _reference(name)
        if is_function(name):
            return FunctionTarget(name, host_command(name), limits)
        if is_program(name):
            return AdapterTarget(name, named_command(name), limits)
        if self.adapters.has(name):
            return self.adapters.make(name, limits)
        return CgalMethod(name, limits)


def _offered(offer: Offer[object], number: str | None) -> list[TargetEntry]:
    absent = {name: offer.absence(name) for name in offer.about}
    return [
        TargetEntry(name, number, about, absent[name] is None, absent[name])
        for name, about in offer.about.items()
    ]


def _reference(name: str) -> Target:
    route = name.removeprefix(REFERENCE)
    if route in CONVEX_ROUTES:
        return ConvexReferenceTarget(name, route)
    if route in SPACE_ROUTES:
        return SpaceReferenceTarget(name, route)
    return ReferenceTarget(name, route)


def _cgal_entry(name: str) -> TargetEntry:
    method, raw = method_of_target(name)
    about = ABOUT[method] + (", holes as given" if raw else "")
    try:
        return TargetEntry(name, cgal_version(method, executable_of_target(name)), about, True)
    except (OSError, subprocess.SubprocessError, ValueError, KeyError) as error:
        return TargetEntry(name, None, about, False, str(error))


def _mend(name: str, known: list[str]) -> str:
    """Advice for an unknown target name, which perhaps names a file."""
    if Path(name).is_file():
        return f"write ./{name} for the program of this name"
    return f"{nearest(name, known)}`minkref targets` lists them"


def _named_adapter(name: str) -> TargetEntry:
    named_command(name)
    return TargetEntry(name, None, "an adapter", True)


def is_function(name: str) -> bool:
    return name.startswith(("py:", "so:"))


def is_program(name: str) -> bool:
    return name.startswith("cmd:") or ("/" in name and not is_function(name))


def is_judge(name: str) -> bool:
    return name.startswith(JUDGED)
