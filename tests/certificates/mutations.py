"""Small changes of JSON values that leave them readable."""

from __future__ import annotations

import copy
import random
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

Path = tuple[Any, ...]
LEAST = Fraction(1, 1 << 80)
NO_TRUTH = ("title", "comment", "producer")


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


def mutant(value: Any, path: Path, dice: random.Random) -> tuple[str, Any]:
    """What was done at a place, and the changed copy."""
    changed = copy.deepcopy(value)
    parent, name = at(changed, path[:-1]), path[-1]
    old = parent[name]
    if isinstance(old, bool):
        parent[name] = not old
        return "negated", changed
    if isinstance(old, int):
        parent[name] = old + dice.choice((1, -1))
        return "nudged", changed
    if isinstance(old, str):
        try:
            parent[name] = str(Fraction(old) + dice.choice((1, -1, LEAST, -LEAST)))
        except ValueError:
            parent[name] = old[:-1] + ("1" if old.endswith("0") else "0")
        return "altered", changed
    if isinstance(old, dict):
        del old[dice.choice(sorted(old))]
        return "member dropped", changed
    if not old:
        return "nothing", changed
    i, j = (dice.randrange(len(old)) for _ in range(2))
    what = dice.choice(("dropped", "duplicated", "swapped", "reversed"))
    if what == "dropped":
        del old[i]
    elif what == "duplicated":
        old.insert(i, copy.deepcopy(old[i]))
    elif what == "swapped":
        old[i], old[j] = old[j], old[i]
    else:
        old.reverse()
    return what, changed


def mutants(value: Any, count: int, dice: random.Random) -> Iterator[tuple[Path, str, Any]]:
    """Changed values and where they were changed, in equal shares by member of a step or claim."""
    groups: dict[Path, list[Path]] = {}
    for path in places(value):
        if path[0] not in NO_TRUTH:
            groups.setdefault(tuple(x for x in path if isinstance(x, str)), []).append(path)
    names = sorted(groups)
    made = 0
    while made < count:
        path = dice.choice(groups[names[made % len(names)]])
        what, changed = mutant(value, path, dice)
        made += 1
        if changed != value:
            yield path, what, changed
