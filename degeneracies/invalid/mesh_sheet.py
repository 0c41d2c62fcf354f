"""A polyhedron on its way to a file: its tokens may still be changed, and lines are known."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from random import Random

from minkref.degeneracies.invalid.member import PREFIX, Invalid
from minkref.degeneracies.invalid.sheet import told
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.plane.families.drawing import convex
from minkref.fuzz.space.generators.convex import random_hull
from minkref.fuzz.space.hull import convex_hull

MESH = f"{PREFIX}mesh-"
FORMS = ("off", "obj", "ply", "json")
FACTORS = tuple(Fraction(n, d) for n, d in ((1, 1), (1, 2), (5, 1), (1, 3), (22, 7), (1, 1000)))


@dataclass
class MeshSheet:
    """`vertices`: the texts of their coordinates; `faces`: the texts of their indices, from 0."""

    form: str
    vertices: list[list[str]]
    faces: list[list[str]]
    operand: str

    @property
    def name(self) -> str:
        return f"{self.operand}.{self.form}"

    @property
    def head(self) -> list[str]:
        """The lines before the vertices."""
        counts = len(self.vertices), len(self.faces)
        if self.form == "off":
            return ["OFF", f"{counts[0]} {counts[1]} 0"]
        if self.form == "obj":
            return ["# a polyhedron"]
        if self.form == "json":
            return ['{"vertices": [']
        return [
            "ply",
            "format ascii 1.0",
            f"element vertex {counts[0]}",
            *(f"property double {axis}" for axis in "xyz"),
            f"element face {counts[1]}",
            "property list uchar int vertex_indices",
            "end_header",
        ]

    def lines(self) -> list[str]:
        rows = [self._vertex(k) for k in range(len(self.vertices))]
        rings = [self._face(k) for k in range(len(self.faces))]
        if self.form == "json":
            return [*self.head, *rows, '], "faces": [', *rings, "]}"]
        return [*self.head, *rows, *rings]

    def text(self) -> str:
        return "\n".join(self.lines()) + "\n"

    def line_of_vertex(self, number: int) -> int:
        return len(self.head) + number + 1

    def line_of_face(self, number: int) -> int:
        return self.line_of_vertex(len(self.vertices) + number) + (self.form == "json")

    def _vertex(self, number: int) -> str:
        row = self.vertices[number]
        if self.form == "json":
            comma = "," if number + 1 < len(self.vertices) else ""
            return "[" + ", ".join(f'"{text}"' for text in row) + f"]{comma}"
        return ("v " if self.form == "obj" else "") + " ".join(row)

    def _face(self, number: int) -> str:
        row = self.faces[number]
        if self.form == "json":
            return "[" + ", ".join(row) + "]" + ("," if number + 1 < len(self.faces) else "")
        if self.form == "obj":
            return "f " + " ".join(str(int(text) + 1) for text in row)
        return f"{len(row)} " + " ".join(row)


def body(dice: Random, corners: int = 3) -> Polyhedron:
    """A convex body, one face having at least so many corners; vertices and faces in any order."""
    while True:
        kind = dice.randrange(3)
        if kind == 0 and corners <= 3:
            found = random_hull(dice, dice.randint(4, 9), 9)
        else:
            ring = convex(dice, dice.randint(max(4, corners), 8), 9)
            high = [(Fraction(x), Fraction(y), Fraction(5)) for x, y in ring]
            low = [(Fraction(x), Fraction(y), Fraction(0)) for x, y in ring]
            found = convex_hull([*low, *(high if kind else high[:1])])
        if max(map(len, found.faces)) >= corners:
            return shuffled(dice, found)


def shuffled(dice: Random, given: Polyhedron) -> Polyhedron:
    order = list(range(len(given.vertices)))
    dice.shuffle(order)
    faces = []
    for face in given.faces:
        k = dice.randrange(len(face))
        faces.append(tuple(order[i] for i in (*face[k:], *face[:k])))
    dice.shuffle(faces)
    places = {order[k]: k for k in order}
    return Polyhedron(tuple(given.vertices[places[k]] for k in range(len(order))), tuple(faces))


def sheet(dice: Random, mesh: Polyhedron, forms: Sequence[str] = FORMS) -> MeshSheet:
    """In other coordinates."""
    factor, move = dice.choice(FACTORS), [dice.randint(-20, 20) for _ in range(3)]
    vertices = [
        [str(factor * c + m) for c, m in zip(point, move, strict=True)] for point in mesh.vertices
    ]
    faces = [[str(k) for k in face] for face in mesh.faces]
    return MeshSheet(dice.choice(forms), vertices, faces, dice.choice("PQ"))


def refused(
    page: MeshSheet, name: str, code: str, *place: str, content: str | bytes | None = None
) -> Invalid:
    """Makes the member from the sheet's text, or from other content."""
    made = page.text() if content is None else content
    data = made if isinstance(made, bytes) else made.encode()
    return Invalid(
        MESH + name, code, page.name, data, place or (page.name,), page.operand, slow_reads=False
    )


def vertex_text(page: MeshSheet, vertex: int) -> str:
    """A vertex as messages write it."""
    return "(" + ", ".join(told(text) for text in page.vertices[vertex]) + ")"


def middle(mesh: Polyhedron, face: Sequence[int]) -> Point:
    """Returns the mean of the corners."""
    x, y, z = (
        sum(column) / len(face) for column in zip(*(mesh.vertices[k] for k in face), strict=True)
    )
    return x, y, z
