"""Mesh readers: OFF, OBJ, PLY, STL as text and binary, plain JSON. Coordinates stay texts (binary
files give doubles)."""

from __future__ import annotations

import struct
from typing import Any

from minkref.reports.evidence.as_written.read_plane import load

Corners = list[tuple[Any, Any, Any]]
Mesh = tuple[Corners, list[list[int]]]


def _lines(text: str, comment: str) -> list[list[str]]:
    words = [line.split(comment)[0].split() for line in text.splitlines()]
    return [line for line in words if line]


def off(text: str) -> Mesh:
    lines = _lines(text, "#")
    if lines[0] != ["OFF"]:
        raise ValueError(f"OFF begins with its name, not {lines[0]}")
    points, faces, _ = map(int, lines[1])
    if len(lines) != 2 + points + faces:
        raise ValueError("more or fewer lines than the head says")
    corners: Corners = [(x, y, z) for x, y, z in lines[2 : 2 + points]]
    return corners, [_counted(line) for line in lines[2 + points :]]


def _counted(line: list[str]) -> list[int]:
    size = int(line[0])
    if len(line) != size + 1:
        raise ValueError(f"a face of {size} corners has {len(line) - 1}")
    return [int(word) for word in line[1:]]


def obj(text: str) -> Mesh:
    corners: Corners = []
    faces: list[list[int]] = []
    for word, *rest in _lines(text, "#"):
        if word == "v":
            x, y, z = rest
            corners.append((x, y, z))
        elif word == "f":
            faces.append([int(one.split("/")[0]) - 1 for one in rest])
        elif word not in ("o", "g"):
            raise ValueError(f"{word} is no word of a mesh")
    return corners, faces


def ply(text: str) -> Mesh:
    head, _, body = text.partition("end_header\n")
    counts = {
        line.split()[1]: int(line.split()[2])
        for line in head.splitlines()
        if line.startswith("element")
    }
    if "format ascii 1.0" not in head.splitlines():
        raise ValueError("a PLY in text")
    lines = [line.split() for line in body.splitlines() if line.strip()]
    points = counts["vertex"]
    if len(lines) != points + counts["face"]:
        raise ValueError("more or fewer lines than the head says")
    corners: Corners = [(line[0], line[1], line[2]) for line in lines[:points]]
    return corners, [[int(word) for word in line[1 : 1 + int(line[0])]] for line in lines[points:]]


def stl(data: bytes) -> Mesh:
    """Triangles, each with three separate corners."""
    if len(data) >= 84 and len(data) == 84 + 50 * struct.unpack_from("<I", data, 80)[0]:
        values = [
            struct.unpack_from("<9f", data, 96 + 50 * k) for k in range((len(data) - 84) // 50)
        ]
        corners: Corners = [(v[k], v[k + 1], v[k + 2]) for v in values for k in (0, 3, 6)]
    else:
        lines = _lines(data.decode(), "\x00")
        if lines[0][0] != "solid" or lines[-1][0] != "endsolid":
            raise ValueError("a solid has a beginning and an end")
        corners = [(line[1], line[2], line[3]) for line in lines if line[0] == "vertex"]
        if len(corners) != 3 * sum(line[0] == "facet" for line in lines):
            raise ValueError("a facet has three corners")
    return corners, [[k, k + 1, k + 2] for k in range(0, len(corners), 3)]


def plain_json(text: str) -> Mesh:
    value = load(text)
    return [(x, y, z) for x, y, z in value["vertices"]], [
        list(map(int, one)) for one in value["faces"]
    ]
