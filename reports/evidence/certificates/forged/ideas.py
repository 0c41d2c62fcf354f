"""Ideas of forgeries, each a function that makes one from a true certificate; their registry."""

from __future__ import annotations

import hashlib
import json
import random
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field

from minkref.reports.evidence.certificates.forged.raw import Json, Raw

FALSE = "false"  # a claim does not hold
UNPROVED = "unproved"  # the claims may hold, and a rule of the pages is broken
Text = str | bytes
PLANE = ("certificate-v1", "axes-certificate-v1")
PATH, UNION = ("path-certificate-v1",), ("union-certificate-v1",)
DISC, FEATURE = ("disc-sum-certificate-v1",), ("feature-certificate-v1",)
CONVEX, SOLID = ("convex-certificate-v1",), ("solid-certificate-v1",)
POINTS = ("solid-point-certificate-v1",)
ALL = PLANE + PATH + UNION + DISC + FEATURE + CONVEX + SOLID + POINTS


@dataclass
class Forgery:
    """Texts of a certificate and, if changed, the case."""

    certificate: Text
    case: Text | None = None
    case_name: str | None = None  # the file's name, unless `it.case.json`


class Unfit(Exception):
    """The idea does not fit the certificate."""


@dataclass
class Maker:
    """All that an idea may take: true certificates of all forms, and dice."""

    dice: random.Random
    raws: Sequence[Raw]

    def another(self, raw: Raw, *names: str) -> Raw:
        """A different certificate of the form, with any of these names if given."""
        found = [
            other for other in self.raws
            if other.name != raw.name and other.form == raw.form
            and (not names or other.name.rstrip("0123456789") in names)
        ]  # fmt: skip
        if not found:
            raise Unfit
        return self.dice.choice(found)

    def pick(self, found: Sequence[Json]) -> Json:
        if not found:
            raise Unfit
        return self.dice.choice(found)

    def claim(self, certificate: Json, *kinds: str) -> Json:
        return self.pick([c for c in certificate["claims"] if not kinds or c["claim"] in kinds])

    def step(self, certificate: Json, *rules: str) -> Json:
        return self.pick([s for s in certificate.get("steps", []) if s["rule"] in rules])


Idea = Callable[[Raw, Maker], Forgery | Json]


@dataclass(frozen=True)
class Kept:
    name: str
    kind: str
    forms: tuple[str, ...]
    make: Idea
    raws: tuple[str, ...] = field(default=())

    def fits(self, raw: Raw) -> bool:
        if raw.form not in self.forms:
            return False
        return not self.raws or raw.name.rstrip("0123456789") in self.raws


IDEAS: list[Kept] = []


def idea(kind: str, *forms: str, raws: Sequence[str] = ()) -> Callable[[Idea], Idea]:
    """Keeps a function as an idea for these forms, and perhaps only these raw certificates."""

    def keep(make: Idea) -> Idea:
        IDEAS.append(Kept(make.__name__, kind, tuple(forms), make, tuple(raws)))
        return make

    return keep


def forged(kept: Kept, raw: Raw, maker: Maker) -> Forgery:
    """Raises Unfit where the idea does not fit, or changes nothing."""
    made = kept.make(raw, maker)
    if not isinstance(made, Forgery):
        if made == raw.certificate:
            raise Unfit
        made = Forgery(json.dumps(made))
    return made


def sha(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()


def tight(value: Json) -> str:
    return json.dumps(value, separators=(",", ":"))


def case_digest(case: Json, form: str) -> str:
    """The digest that the pages give for a case whose numbers are in lowest terms."""
    if form in CONVEX + SOLID + POINTS:
        return sha(tight({name: {"faces": case[name]["faces"], "vertices": case[name]["vertices"]}
                          for name in ("P", "Q")}))  # fmt: skip
    if form in UNION:
        return sha(tight({"sets": [_polygons(each) for each in case["sets"]]}))
    names = {**dict.fromkeys(PLANE, "PQ"), **dict.fromkeys(PATH, "OR")}.get(form, "P")
    value = {name: _polygons(case[name]) for name in names}
    if form in PATH:
        value["path"] = case["path"]
    return sha(tight(value))


def _polygons(operand: Json) -> Json:
    return [{"holes": polygon.get("holes") or [], "outer": polygon["outer"]}
            for polygon in operand["polygons"]]  # fmt: skip


def places(value: Json, path: tuple[str | int, ...] = ()) -> Iterator[tuple[str | int, ...]]:
    """Paths of all values within a value, the outermost first."""
    if path:
        yield path
    if isinstance(value, (dict, list)):
        for key, below in value.items() if isinstance(value, dict) else enumerate(value):
            yield from places(below, (*path, key))


def at(value: Json, path: Sequence[str | int]) -> Json:
    for key in path:
        value = value[key]
    return value


def put(value: Json, path: Sequence[str | int], new: Json) -> None:
    at(value, path[:-1])[path[-1]] = new
