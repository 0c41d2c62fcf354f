"""Small changes to JSON values that keep them readable."""

from __future__ import annotations

import copy
import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

Path = tuple[Any, ...]
LEAST = Fraction(1, 1 << 80)
# Members that carry a claim's content, unlike names of steps or pieces
TOLD = (
    "scale", "components", "holes", "digest", "polygons", "point", "p", "q", "points", "of",
    "from", "to", "sign", "kind", "before", "at", "after", "scales", "kinds", "passages",
)  # fmt: skip
NO_TRUTH = ("title", "comment", "producer")
TREE = 2  # position among a plane's parts; an entry's path is proof, sums, i, planes, j, 2, k


@dataclass(frozen=True)
class Mutant:
    """`field`: the rule or claim, and the names on the way to the change."""

    field: str
    way: str
    path: Path
    value: Any


def mutants(value: Any, each: int, dice: random.Random) -> Iterator[Mutant]:
    """Mutants for each field of each step and claim (also of the case, and the lists themselves),
    changed in each fitting way: `each` at random places, or fewer if no more exist."""
    fields: dict[str, list[Path]] = {}
    for path in places(value):
        if path[0] not in NO_TRUTH:
            fields.setdefault(_field(value, path), []).append(path)
    for field, paths in sorted(fields.items()):
        for way in sorted({way for path in paths for way in _ways(at(value, path))}):
            fitting = [path for path in paths if way in _ways(at(value, path))]
            made: list[Any] = []
            for path in dice.sample(fitting, min(len(fitting), 4 * each)):
                changed = copy.deepcopy(value)
                parent = at(changed, path[:-1])
                parent[path[-1]] = WAYS[way](parent[path[-1]], dice)
                if len(made) < each and changed != value and changed not in made:
                    made.append(changed)
                    yield Mutant(field, way, path, changed)


def places(value: Any, path: Path = ()) -> Iterator[Path]:
    if path:
        yield path
    if isinstance(value, dict):
        for name in value:
            yield from places(value[name], (*path, name))
    elif isinstance(value, list):
        for i, entry in enumerate(value):
            yield from places(entry, (*path, i))


def at(value: Any, path: Path) -> Any:
    for name in path:
        value = value[name]
    return value


def _field(value: Any, path: Path) -> str:
    """A field's name, such as `steps/eq/cells//` for a cell's corner: each number on the way
    becomes a slash."""
    names = [str(name) if isinstance(name, str) else "" for name in path]
    if len(path) > 1 and path[0] in ("steps", "claims"):
        entry = value[path[0]][path[1]]
        names[1] = entry.get("rule") or entry["claim"]
    if path[0] == "proof" and path[5:6] == (TREE,) and len(path) > 6:
        names[6] = at(value, path[:7])[0]
    return "/".join(names)


def _nudged(by: int | Fraction) -> Callable[[Any, random.Random], Any]:
    return lambda old, _: old + by if isinstance(old, int) else str(Fraction(old) + by)


def _altered(old: str, dice: random.Random) -> str:
    if not old:
        return "x"
    i = dice.randrange(len(old))
    return old[:i] + ("1" if old[i] != "1" else "2") + old[i + 1 :]


def _without(old: Any, dice: random.Random) -> Any:
    gone = dice.choice(sorted(old)) if isinstance(old, dict) else dice.randrange(len(old))
    if isinstance(old, dict):
        return {name: old[name] for name in old if name != gone}
    return [entry for i, entry in enumerate(old) if i != gone]


def _twice(old: list[Any], dice: random.Random) -> list[Any]:
    i = dice.randrange(len(old))
    return [*old[: i + 1], *copy.deepcopy(old[i:])]


def _swapped(old: list[Any], dice: random.Random) -> list[Any]:
    i, j = dice.sample(range(len(old)), 2)
    new = list(old)
    new[i], new[j] = new[j], new[i]
    return new


WAYS: dict[str, Callable[[Any, random.Random], Any]] = {
    "1 more": _nudged(1),
    "1 less": _nudged(-1),
    "2^-80 more": _nudged(LEAST),
    "2^-80 less": _nudged(-LEAST),
    "a character altered": _altered,
    "dropped": _without,
    "duplicated": _twice,
    "swapped": _swapped,
    "reversed": lambda old, _: old[::-1],
    "emptied": lambda old, _: type(old)(),
}


def _ways(value: Any) -> tuple[str, ...]:
    if isinstance(value, int):
        return "1 more", "1 less"
    if isinstance(value, str):
        return tuple(WAYS)[:4] if _is_number(value) else ("a character altered",)
    if isinstance(value, dict):
        return ("dropped",)
    if not isinstance(value, list) or not value:
        return ()
    return tuple(WAYS)[5:] if len(value) > 1 else ("dropped", "duplicated", "emptied")


def _is_number(text: str) -> bool:
    try:
        Fraction(text)
    except (ValueError, ZeroDivisionError):
        return False
    return True


def is_changed(claims: Any, whole: list[dict[str, Any]]) -> bool:
    """Whether the claims mention a set, interval, event, point, passage or sign that `whole`
    lacks."""

    def is_old(claim: dict[str, Any]) -> bool:
        told = [name for name in TOLD if name in claim]
        return any(all(old.get(name) == claim[name] for name in told) for old in whole)

    return not all(map(is_old, claims))
