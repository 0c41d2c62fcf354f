"""A picture reader: an SVG's paths by class, with ends, arcs and decimals."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from dataclasses import dataclass

TOKEN = re.compile(r"([MLAZ])|([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)|[\s,]+|(.)")
NUMBERS = {"M": 2, "L": 2, "A": 7, "Z": 0}


@dataclass(frozen=True)
class Step:
    """To a place, on a line or an arc of a radius."""

    x: str
    y: str
    radius: str | None = None
    large: bool = False


def paths(text: str) -> dict[str, list[list[Step]]]:
    """Closed rings for each class of paths. Skips other elements."""
    found: dict[str, list[list[Step]]] = {}
    for element in ET.fromstring(text).iter("{http://www.w3.org/2000/svg}path"):
        rings = found.setdefault(element.get("class", ""), [])
        rings += rings_of(element.get("d", ""))
    return found


def rings_of(d: str) -> list[list[Step]]:
    """A path's subpaths in absolute coordinates; drops a repeated first place."""
    rings: list[list[Step]] = []
    for letter, numbers in _commands(d):
        if letter == "M":
            rings.append([Step(numbers[0], numbers[1])])
        elif letter == "L":
            rings[-1].append(Step(numbers[0], numbers[1]))
        elif letter == "A":
            rx, ry, _, large, sweep, x, y = numbers
            if rx != ry or sweep != "0":
                raise ValueError("arcs of circles, counter-clockwise")
            rings[-1].append(Step(x, y, rx, large == "1"))
    for ring in rings:
        first, last = ring[0], ring[-1]
        if len(ring) > 1 and (first.x, first.y) == (last.x, last.y):
            ring[0] = ring.pop()
    return rings


def _commands(d: str) -> list[tuple[str, list[str]]]:
    commands: list[tuple[str, list[str]]] = []
    for letter, number, other in TOKEN.findall(d):
        if other or (number and not commands):
            raise ValueError(f"{other or number!r} in a path")
        if letter:
            commands.append((letter, []))
        elif number:
            letter, numbers = commands[-1]
            if letter in "ML" and len(numbers) == 2:  # more places on a line
                commands.append(("L", [number]))
            else:
                numbers.append(number)
    for letter, numbers in commands:
        if len(numbers) != NUMBERS[letter]:
            raise ValueError(f"{letter} has {len(numbers)} numbers")
    return commands
