"""Judges every writer and table for sums of solids against exact numbers."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from typing import Any

import gmpy2
from minkref.reports.evidence.as_written import read_meshes
from minkref.reports.evidence.as_written.answers import Answers, Document
from minkref.reports.evidence.as_written.inputs_space import Solids
from minkref.reports.evidence.as_written.judge_plane import approximate, area_told
from minkref.reports.evidence.as_written.read_meshes import Mesh
from minkref.reports.evidence.as_written.tally import Tally, told
from minkref.reports.evidence.as_written.units import exact, exact_double

READERS: dict[str, Callable[[str], Mesh]] = {
    "off": read_meshes.off, "obj": read_meshes.obj, "ply": read_meshes.ply,
    "stl": lambda text: read_meshes.stl(text.encode()),
}  # fmt: skip
Corner = tuple[Any, Any, Any]


def judge(tally: Tally, answers: Answers, solids: Solids) -> None:
    files = [answers.folder / f"{name}.off" for name in "PQ"]
    for path, text in zip(files, (solids.P, solids.Q), strict=True):
        path.write_text(text)
    words = ("sum", *files, "--scale", solids.scale)
    text, table = answers.file("json", *words)
    corners, faces = read_meshes.plain_json(text)
    true = [tuple(map(exact, corner)) for corner in corners]
    volume = volume_of(true, faces)
    area_told(tally, "table of sum in space", table, volume)
    for ending, reader in READERS.items():
        with tally.answer(f".{ending}"):
            path = answers.folder / f"said.{ending}"
            document = answers.document(*words, "-o", path)
            found = reader(answers.read(path))
            order = _order(found, true) if ending == "stl" else list(range(len(true)))
            _corners(tally, f".{ending}", found, true, faces, order)
            _said(
                tally,
                f".{ending}",
                document,
                true,
                [found[0][order.index(k)] for k in range(len(true))],
            )
    for ending in ("off", "obj", "ply", "stl"):
        with tally.answer(f".{ending} --triangles"):
            text, _ = answers.file(ending, *words, "--triangles")
            _triangles(tally, f".{ending} --triangles", READERS[ending](text), true)
    document = answers.document(*words)
    tally.numbers["sum in space --json"] += 2
    if exact(document["volume"]) != volume:
        tally.fault("sum in space --json", "a volume that is not exact", document["volume"])
    approximate(tally, "sum in space --json", document["volume_approximate"], volume)


def volume_of(corners: list[Any], faces: list[list[int]]) -> Any:
    """Exactly, by Gauss's theorem."""
    total = gmpy2.mpq(0)
    for face in faces:
        a = corners[face[0]]
        for k in range(1, len(face) - 1):
            b, c = corners[face[k]], corners[face[k + 1]]
            total += (
                a[0] * (b[1] * c[2] - b[2] * c[1])
                + a[1] * (b[2] * c[0] - b[0] * c[2])
                + a[2] * (b[0] * c[1] - b[1] * c[0])
            )
    return total / 6


def _corners(
    tally: Tally,
    writer: str,
    found: Mesh,
    true: list[Any],
    faces: list[list[int]],
    order: list[int],
) -> None:
    corners, found_faces = found
    edges = Counter[tuple[int, int]]()
    if writer == ".stl":
        if sum(len(face) - 2 for face in faces) != len(found_faces):
            tally.fault(
                writer, "more or fewer triangles than the faces give", str(len(found_faces))
            )
    else:
        if len(corners) != len(true):
            tally.fault(writer, "more or fewer vertices than the sum has", str(len(corners)))
            return
        if found_faces != faces:
            tally.fault(writer, "other faces than the exact file", "")
    for corner, number in zip(corners, order, strict=True):
        for text, value in zip(corner, true[number], strict=True):
            tally.number(writer, text, value, "a coordinate")
            tally.number(f"{writer} as doubles", repr(float(text)), value, "a coordinate")
    for face in found_faces:
        for a, b in zip(face, (*face[1:], face[0]), strict=True):
            edges[order[a], order[b]] += 1
    if any(edges[b, a] != count for (a, b), count in edges.items()):
        tally.fault(writer, "faces that are not closed", "")


def _triangles(tally: Tally, writer: str, found: Mesh, true: list[Any]) -> None:
    """Triangles with vertices of the sum; but for STL, each edge has two, one for each way."""
    corners, faces = found
    for corner, number in zip(corners, _order(found, true), strict=True):
        for text, value in zip(corner, true[number], strict=True):
            tally.number(writer, repr(float(text)), value, "a coordinate")
    if any(len(face) != 3 for face in faces):
        tally.fault(writer, "a face that is no triangle", "")
    edges = Counter(edge for a, b, c in faces for edge in ((a, b), (b, c), (c, a)))
    if writer.startswith(".stl"):
        return
    if any(count != 1 or edges[b, a] != 1 for (a, b), count in edges.items()):
        tally.fault(writer, "an edge that has not two triangles", "")


def _order(found: Mesh, true: list[Any]) -> list[int]:
    """The number of the vertex nearest to each written corner."""
    known: dict[Corner, int] = {}
    for corner in found[0]:
        if corner not in known:
            place = [exact(text) for text in corner]
            far = [max(abs(a - b) for a, b in zip(place, one, strict=True)) for one in true]
            known[corner] = far.index(min(far))
    return [known[corner] for corner in found[0]]


def _said(
    tally: Tally, writer: str, document: Document, true: list[Any], corners: list[Corner]
) -> None:
    """`rounding`, as a reader of doubles sees the vertices."""
    read = [tuple(exact_double(float(text)) for text in corner) for corner in corners]
    moved = [k for k, corner in enumerate(true) if corner != read[k]]
    tally.numbers[f"{writer} rounding"] += 1
    if not moved:
        return
    rounding = document["rounding"]
    if rounding is None:
        tally.fault(
            writer, "rounding is not said", f"{len(moved)} of {len(true)} vertices are no doubles"
        )
        return
    far = max(abs(a - b) for k in moved for a, b in zip(true[k], read[k], strict=True))
    merged = len(set(true)) - len(set(read))
    for name, value in (
        ("moved_vertices", len(moved)),
        ("merged_vertices", merged),
        ("largest_displacement", far),
    ):
        if exact(rounding[name]) != value:
            tally.fault(writer, f"another {name}", f"{rounding[name]}, true {told(value)}")
