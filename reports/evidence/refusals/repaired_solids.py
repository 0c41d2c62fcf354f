"""Damaged polyhedra, each kind in turn: the repaired solid has the volume and the points of the
solid before the damage, by rays cast in Fractions."""

from __future__ import annotations

import json
import random
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from tempfile import TemporaryDirectory

from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.refusals.repairing import Repair, repair

MINUTES = Minutes(0.05, 0.2, 2)
FILES = Counts(22, 99, 1000)
POINTS = 24
SEED = 978
Point = tuple[Fraction, Fraction, Fraction]
WELD = Fraction(1, 10**6)
LEADS_TO = {
    "zero-area": {"edge-split"},
    "opposite-face": {"joined"},
    "split-vertex": {"joined", "unused-vertex"},
}
CORNERS = [(k & 1, k >> 1 & 1, k >> 2 & 1) for k in range(8)]
FACES = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]


@dataclass
class Solid:
    """Vertices and faces, as written; `boxes`: the material, of boxes that may be cut out."""

    points: list[Point]
    faces: list[list[int]]
    boxes: list[tuple[Point, Point]]
    hollows: list[tuple[Point, Point]]
    expected: str = ""
    weld: Fraction | None = None

    def add(self, low: Point, high: Point, inwards: bool = False) -> None:
        """Write the faces of a box."""
        first = len(self.points)
        for corner in CORNERS:
            x, y, z = ((low, high)[corner[k]][k] for k in range(3))
            self.points.append((x, y, z))
        for face in FACES:
            self.faces.append([first + v for v in (face[::-1] if inwards else face)])

    def text(self) -> str:
        points = [[str(x) for x in point] for point in self.points]
        return json.dumps({"vertices": points, "faces": self.faces})


def damaged(index: int) -> tuple[str, Solid]:
    dice = random.Random(f"minkref solids {SEED} {index}")
    low = (_number(dice), _number(dice), _number(dice))
    high = (low[0] + dice.randint(2, 9), low[1] + dice.randint(2, 9), low[2] + dice.randint(2, 9))
    solid = Solid([], [], [(low, high)], [])
    solid.add(low, high)
    name, do = list(KINDS.items())[index % len(KINDS)]
    do(dice, solid)
    return f"{index} {name}", solid


def _number(dice: random.Random) -> Fraction:
    return Fraction(dice.randint(-70, 70), dice.choice((1, 7, 10)))


def _soup(dice: random.Random, solid: Solid) -> None:
    solid.points, solid.faces = (
        [solid.points[v] for face in solid.faces for v in face],
        [[4 * k + j for j in range(4)] for k in range(6)],
    )
    solid.expected = "joined"


def _near(dice: random.Random, solid: Solid) -> None:
    _soup(dice, solid)
    for k in range(8, 24):
        x, y, z = solid.points[k]
        solid.points[k] = (x + Fraction(dice.randint(-9, 9), 10**8), y, z)
    solid.weld = WELD


def _bent(dice: random.Random, solid: Solid) -> None:
    """A corner a little off: three faces are in no plane. The volume is judged with a margin."""
    x, y, z = solid.points[7]
    solid.points[7] = (x + Fraction(1, 10**9), y + Fraction(1, 10**9), z + Fraction(3, 10**9))
    solid.expected = "triangulated"


def _turned_face(dice: random.Random, solid: Solid) -> None:
    solid.faces[dice.randrange(6)].reverse()
    solid.expected = "turned-face"


def _turned_shell(dice: random.Random, solid: Solid) -> None:
    solid.faces = [face[::-1] for face in solid.faces]
    solid.expected = "turned-shell"


def _twice(dice: random.Random, solid: Solid) -> None:
    at = dice.randrange(6)
    face = solid.faces[at]
    solid.faces.insert(dice.randint(0, 6), face[2:] + face[:2])
    solid.expected = "duplicate-face"


def _flat(dice: random.Random, solid: Solid) -> None:
    """A vertex on an edge of one face only, and a triangle without area there."""
    a, b = solid.faces[0][:2]
    p, q = solid.points[a], solid.points[b]
    t = Fraction(dice.randint(1, 6), 7)
    solid.points.append(tuple(x + t * (y - x) for x, y in zip(p, q, strict=True)))  # type: ignore[arg-type]
    middle = len(solid.points) - 1
    solid.faces[0].insert(1, middle)
    solid.faces.append([b, middle, a])
    solid.expected = "zero-area"


def _abut(dice: random.Random, solid: Solid) -> None:
    (low, high) = solid.boxes[0]
    other = ((high[0], low[1], low[2]), (high[0] + dice.randint(1, 5), high[1], high[2]))
    solid.boxes.append(other)
    solid.add(*other)
    solid.expected = "opposite-face"


def _along_edge(dice: random.Random, solid: Solid) -> None:
    (low, high) = solid.boxes[0]
    other = ((high[0], high[1], low[2]), (high[0] + 2, high[1] + 3, high[2]))
    solid.boxes.append(other)
    solid.add(*other)
    first: dict[Point, int] = {}
    names = [first.setdefault(point, k) for k, point in enumerate(solid.points)]
    solid.faces = [[names[v] for v in face] for face in solid.faces]
    solid.expected = "split-vertex"


def _nested(dice: random.Random, solid: Solid) -> None:
    (low, high) = solid.boxes[0]
    inner = tuple(tuple((2 * a + b) / 3 for a, b in zip(p, q, strict=True))
                  for p, q in ((low, high), (high, low)))  # fmt: skip
    solid.add(*inner)  # type: ignore[arg-type]
    solid.expected = "dropped-shell"


def _cavity(dice: random.Random, solid: Solid) -> None:
    """A cavity, and a vertex of no face."""
    (low, high) = solid.boxes[0]
    inner = tuple(tuple((2 * a + b) / 3 for a, b in zip(p, q, strict=True))
                  for p, q in ((low, high), (high, low)))  # fmt: skip
    solid.add(*inner, inwards=True)  # type: ignore[arg-type, misc]
    solid.hollows.append(inner)  # type: ignore[arg-type]
    solid.points.append((Fraction(99), Fraction(99), Fraction(99)))
    solid.expected = "unused-vertex"


KINDS: dict[str, Callable[[random.Random, Solid], None]] = {
    "faces with vertices of their own": _soup,
    "vertices too near": _near,
    "faces in no plane": _bent,
    "a face turned": _turned_face,
    "a shell turned": _turned_shell,
    "a face twice": _twice,
    "a face without area": _flat,
    "bodies that abut": _abut,
    "bodies along an edge": _along_edge,
    "a body in another": _nested,
    "a cavity and a loose vertex": _cavity,
}


def run(findings: Findings, size: Size) -> None:
    wrong, again, silent, made_up = [], [], [], []
    kinds: Counter[str] = Counter()
    with TemporaryDirectory() as folder:
        for index in range(size.of(FILES)):
            name, solid = damaged(index)
            found = repaired_solid(solid, Path(folder))
            told = {change["kind"] for change in found.changes}
            kinds.update(told)
            wrong += [name] * bool(other_solid(solid, found, random.Random(index)))
            again += [name] * bool(found.again)
            expected = {solid.expected or "joined"}
            silent += [name] * (not told >= expected)
            made_up += [name] * (not told <= expected | LEADS_TO.get(solid.expected, set()))
    findings.none("solids other than those that were damaged", wrong)
    findings.none("repaired files that need repair", again)
    findings.none("files with damage that no change names", silent)
    findings.none("files with a change of a kind that the damage does not lead to", made_up)
    findings.figures |= {"files": size.of(FILES), "kinds of damage": len(KINDS)}
    findings.figures["files with a change, by kind"] = dict(sorted(kinds.items()))


def repaired_solid(solid: Solid, folder: Path) -> Repair:
    file = folder / "damaged.json"
    file.write_text(solid.text(), encoding="utf-8")
    return repair(file, folder / "repaired.json", "nonzero", solid.weld)


def other_solid(solid: Solid, found: Repair, dice: random.Random) -> str:
    """A point or a volume that differs from the material; near-equal where corners were moved."""
    mesh = json.loads(found.output)
    points = [tuple(map(Fraction, point)) for point in mesh["vertices"]]
    triangles = [
        (points[face[0]], points[face[k]], points[face[k + 1]])
        for face in mesh["faces"]
        for k in range(1, len(face) - 1)
    ]
    volume = sum((_det(a, b, c) for a, b, c in triangles), Fraction(0)) / 6
    wanted = sum(map(_volume, solid.boxes)) - sum(map(_volume, solid.hollows))
    margin = Fraction(1, 1000) if solid.weld or solid.expected == "triangulated" else 0
    if abs(volume - wanted) > margin:
        return f"the volume {volume}"
    lows = [min(p[k] for p in points) for k in range(3)]
    highs = [max(p[k] for p in points) for k in range(3)]
    for _ in range(POINTS):
        at = tuple(low + (high - low) * Fraction(dice.randint(-50, 1049), 997)
                   for low, high in zip(lows, highs, strict=True))  # fmt: skip
        inside = any(_holds(b, at) for b in solid.boxes) and not any(
            _holds(b, at) for b in solid.hollows
        )
        if _winding(triangles, at) != int(inside):
            return str(at)
    return ""


def _volume(box: tuple[Point, Point]) -> Fraction:
    (a, b, c), (x, y, z) = box
    return (x - a) * (y - b) * (z - c)


def _holds(box: tuple[Point, Point], at: tuple[Fraction, ...]) -> bool:
    return all(low < x < high for low, x, high in zip(box[0], at, box[1], strict=True))


def _det(a: tuple[Fraction, ...], b: tuple[Fraction, ...], c: tuple[Fraction, ...]) -> Fraction:
    return (
        a[0] * (b[1] * c[2] - b[2] * c[1])
        - a[1] * (b[0] * c[2] - b[2] * c[0])
        + a[2] * (b[0] * c[1] - b[1] * c[0])
    )


def _winding(
    triangles: Sequence[tuple[tuple[Fraction, ...], ...]], at: tuple[Fraction, ...]
) -> int:
    """Cast a ray; the direction misses all edges."""
    way = (Fraction(101, 977), Fraction(89, 991), Fraction(1))
    total = 0
    for triangle in triangles:
        a, b, c = (tuple(x - y for x, y in zip(p, at, strict=True)) for p in triangle)
        sides = [_det(way, a, b), _det(way, b, c), _det(way, c, a)]
        if not (all(s > 0 for s in sides) or all(s < 0 for s in sides)):
            continue
        height = _det(a, b, c)
        if (height > 0) == (sum(sides) > 0):
            total += 1 if height > 0 else -1
    return total
