"""True certificates from the commands: the raw material of forgeries."""

from __future__ import annotations

import json
import random
import re
import subprocess
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from minkref.reports.evidence.certificates.forged import solids_raw
from minkref.reports.evidence.framework.command import COMMAND

Json = Any
Ring = list[tuple[int, int]]


@dataclass(frozen=True)
class Raw:
    """A certificate, as verified, and the case."""

    name: str
    kind: str  # sum, event, interval, ...: the command's claim
    certificate: Json
    case: Json

    @property
    def form(self) -> str:
        return str(self.certificate["certificate"])

    def copy(self) -> Json:
        return json.loads(json.dumps(self.certificate))

    def copied_case(self) -> Json:
        return json.loads(json.dumps(self.case))


Order = tuple[str, str, list[str], str]  # name, kind, words of the command, option before the file


def text(*polygons: Sequence[Ring]) -> str:
    """Polygons, each an outer ring and holes, as WKT."""

    def ring(points: Ring) -> str:
        return "(" + ",".join(f"{x} {y}" for x, y in [*points, points[0]]) + ")"

    bodies = ["(" + ",".join(map(ring, polygon)) + ")" for polygon in polygons]
    return "MULTIPOLYGON(" + ",".join(bodies) + ")"


def box(x: int, y: int, a: int, b: int) -> Ring:
    return [(x, y), (x + a, y), (x + a, y + b), (x, y + b)]


def frame(dice: random.Random) -> tuple[str, int]:
    """A frame about a square hole, and the hole's width."""
    wide, x, y = dice.randint(2, 5), dice.randint(1, 4), dice.randint(1, 4)
    a, b = x + wide + dice.randint(1, 4), y + wide + dice.randint(1, 4)
    return text([box(0, 0, a, b), box(x, y, wide, wide)[::-1]]), wide


def bent(dice: random.Random) -> Ring:
    """An L."""
    a, b = dice.randint(2, 6), dice.randint(2, 6)
    return [(0, 0), (a + 2, 0), (a + 2, 1), (1, 1), (1, b), (0, b)]


def orders(dice: random.Random, rounds: int, names: Sequence[str] = ()) -> list[Order]:
    """Words of commands, each kind `rounds` times, or these names only."""
    found: list[Order] = []
    for turn in range(rounds):
        for name, kind, words, option in [*plane(dice), *others(dice), *solids_raw.orders(dice)]:
            if not names or name in names:
                found.append((f"{name}{turn}", kind, words, option))
    return found


def plane(dice: random.Random) -> list[Order]:
    rim, wide = frame(dice)
    side = dice.randint(1, 3)
    square = text([box(0, 0, side, side)])
    three = text([[(0, 0), (dice.randint(1, 3), 0), (dice.randint(0, 2), dice.randint(1, 3))]])
    corner = bent(dice)
    ell = text([corner])
    two = text([box(0, 0, 2, 2)], [box(7, dice.randint(0, 3), 2, 3)])
    shut = f"{wide}/{side}"
    low, mid, high = f"{wide}/{4 * side}", f"{wide}/{2 * side}", f"{3 * wide}/{4 * side}"
    s = dice.choice(["1", "2", "1/2", "3/7"])
    made = [
        ("filled", "sum", [rim, three, "--scale", "8"]),
        ("ell", "sum", [ell, three, "--scale", s]),
        ("hull", "sum", [text([hull(corner)]), three, "--scale", s]),
        ("gap", "sum", ["POLYGON((0 0,7 0,7 2.4,4 4,0 4,0 0))", three, "--scale", s]),
        ("plate", "sum", [text([box(0, 0, 6, 6)]), three, "--scale", "9"]),
        (
            "islands",
            "sum",
            [rim[:-1] + f",(({40 + wide} 0,60 0,60 9,{40 + wide} 0)))", three, "--scale", "8"],
        ),
        (
            "touch",
            "sum",
            [text([box(0, 0, 2, side)], [box(2, side, 1, 3)]), "POINT(1 -1)", "--scale", s],
        ),
        ("two", "sum", [two, three, "--scale", "1"]),
        ("tight", "sum", [square, rim, "--scale", shut]),
        ("axes", "axes", [three, rim, "--scale", f"{dice.randint(2, 5)},1/3"]),
        ("topology", "event", [square, rim, "--event", shut]),
        ("still", "interval", [square, rim, "--from", low, "--to", mid]),
        ("middle", "sum", [square, rim, "--scale", mid]),
        ("later", "interval", [square, rim, "--from", mid, "--to", high]),
        ("signs", "sign", [square, rim, "--degeneracy", shut]),
        ("inside", "point", [ell, three, "--scale", "1", "--point", "1/2,1/2"]),
        ("apart", "outside", [ell, three, "--scale", "1", "--point", "50,-50"]),
        ("line", "sum", ["LINESTRING(0 0, 3 1)", ell, "--scale", s]),
        ("place", "sum", ["POINT(1 2)", rim, "--scale", s]),
    ]
    return [(name, kind, ["certify", *words, "--no-check"], "-o") for name, kind, words in made]


def corners(ring: str) -> list[str]:
    """The corners that the text of a ring lists, each once."""
    return re.sub("[A-Z()]", "", ring).split(",")[:-1]


def hull(points: Ring) -> Ring:
    """Corners of the convex hull, counter-clockwise."""
    ordered = sorted(set(points))
    chains: list[Ring] = []
    for way in (ordered, ordered[::-1]):
        chain: Ring = []
        for p in way:
            while len(chain) > 1 and turn(chain[-2], chain[-1], p) <= 0:
                chain.pop()
            chain.append(p)
        chains.append(chain[:-1])
    return chains[0] + chains[1]


def turn(a: tuple[int, int], b: tuple[int, int], c: tuple[int, int]) -> int:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def others(dice: random.Random) -> list[Order]:
    """Paths, traps, unions, discs, features."""
    rim, _ = frame(dice)
    x, y = min(tuple(map(int, corner.split())) for corner in corners(rim.split("),(")[1]))
    unit = text([box(0, 0, 1, 1)])
    rule = dice.choice(["allowed", "forbidden"])
    at = f"{x}.25,{y}.25"
    path = f"LINESTRING({x}.25 {y}.25, {x + 1}.5 {y}.5)"
    door = text([[(0, 0), (9, 0), (9, 3), (8, 3), (8, 1), (1, 1), (1, 8), (8, 8), (8, 5), (9, 5),
                  (9, 9), (0, 9)]])  # fmt: skip
    away = f"LINESTRING({x}.25 {y}.25, 40 {y}.25)"
    other = text([box(1, dice.randint(0, 1), 2, 1)])
    cross = text([[(0, 0), (dice.randint(3, 5), 1), (1, dice.randint(2, 4))]])
    radius = dice.choice(["1/2", "1/3", "3/4"])
    bay = text([[(0, 0), (8, 0), (8, 6), (5, 6), (5, 3), (3, 3), (3, 6), (0, 6)]])
    return [
        ("path", "path", ["path", unit, rim, path, "--contact", rule], "--certify"),
        ("away", "path", ["path", unit, rim, away, "--contact", "allowed"], "--certify"),
        ("trap", "trap", ["trap", unit, rim, "--at", at, "--contact", rule], "--certify"),
        ("door", "escape", ["trap", unit, door, "--at", "3,4", "--contact", rule], "--certify"),
        ("seam", "union", ["union", unit, other, cross], "--certify"),
        ("disjoint", "union", ["union", cross, text([box(20, 0, 1, 1)])], "--certify"),
        ("disc", "disc", ["sum", bay, f"disc:{radius}", "--point", "4,5", "--point", "30,4"],
         "--certify"),
        ("ringdisc", "disc", ["sum", rim, f"disc:{radius}", "--point", "0,0"], "--certify"),
        ("bay", "feature", ["features", bay, "--alpha", radius], "--certify"),
        ("three", "feature", ["features", bay, "--alpha", "2"], "--certify"),
        ("bays", "feature", ["features", rim, "--alpha", "1"], "--certify"),
    ]  # fmt: skip


def made(folder: Path, asked: Sequence[Order]) -> list[Raw]:
    """Runs the commands, two at a time. A command that refuses gives nothing."""
    with ThreadPoolExecutor(2) as pool:
        found = list(pool.map(lambda order: _one(folder, order), asked))
    return [raw for raw in found if raw is not None]


def _one(folder: Path, order: Order) -> Raw | None:
    name, kind, words, option = order
    file = folder / f"{name}.cert.json"
    words = [word.replace("FOLDER", str(folder)) for word in words]
    solids_raw.write(folder)
    command = [*COMMAND, *words, option, str(file)]
    subprocess.run(command, capture_output=True, check=False)
    if not file.exists():
        return None
    certificate = json.loads(file.read_text(encoding="utf-8"))
    case = json.loads((folder / f"{name}.case.json").read_text(encoding="utf-8"))
    return Raw(name, kind, certificate, case)
