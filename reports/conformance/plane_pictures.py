"""The pictures of a case in the plane: operands, expected, got, difference, and the witness as the
place where sP and x - Q meet or do not."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from fractions import Fraction

from minkref import _core
from minkref.exact import approximate
from minkref.fuzz.verdicts.region import minus
from minkref.fuzz.verdicts.verdict import Outcome, Witness
from minkref.reports.drawing import Box, Layer, Polygons, bounds, picture

CLOSE = 0.12  # of the frame: a difference less wide and less high is drawn by itself too


@dataclass(frozen=True)
class Picture:
    caption: str
    svg: str
    box: Box | None = None


def drawable(rings: Polygons) -> bool:
    """Coordinates are finite and not beyond what a picture can scale."""
    return all(abs(c) < 1e300 for polygon in rings for ring in polygon for p in ring for c in p)


def operand_pictures(P: str, Q: str, scale: str) -> list[Picture]:
    scaled = "" if scale == "1" else f", to be scaled by {scale}"
    found = []
    for name, text, style in (("P", P, "first"), ("Q", Q, "second")):
        rings = _core.PolygonSet.from_json(text).rings()
        if drawable(rings):
            caption = f"{name}{scaled if name == 'P' else ''}"
            found.append(Picture(caption, picture([Layer(style, rings)], caption, 260)))
    return found


def comparison_pictures(expected: str, outcome: Outcome) -> list[Picture]:
    """Expected, got and difference in one frame, the witness marked; a close-up where the
    difference is small."""
    wanted = Layer("sum", _core.PolygonSet.from_json(expected).rings())
    groups = [("expected", [wanted])]
    differing: list[Layer] = []
    if outcome.got is not None:
        got = Layer("got", _core.PolygonSet.from_json(outcome.got).rings())
        missing = Layer("missing", minus(expected, outcome.got).rings())
        extra = Layer("extra", minus(outcome.got, expected).rings())
        differing = [missing, extra]
        groups.append((f"got from {outcome.target}", [got]))
        groups.append((_difference(missing, extra), [_faint(wanted), missing, extra]))
    every = [layer for _, layers in groups for layer in layers]
    if not all(drawable(layer.polygons) for layer in every):
        return []
    marks = _marks(outcome.witness)
    box = bounds([*every, *marks])
    found = [
        Picture(caption, picture([*layers, *marks], caption, box=box), box)
        for caption, layers in groups
    ]
    near = bounds(layer for layer in differing if layer.polygons)
    if any(layer.polygons for layer in differing) and _smaller(near, box):
        caption = f"the difference, {_factor(box, near):,.0f} times larger"
        layers = [_faint(wanted), *differing, *marks]
        found.append(Picture(caption, picture(layers, caption, box=_padded(near))))
    return found


def meeting_picture(P: str, Q: str, scale: str, witness: Witness) -> Picture | None:
    """sP and x - Q: a common point, or none."""
    at = witness.scale or scale
    x = [Fraction(number) for number in witness.point]
    turned = {
        "polygons": [
            {
                "outer": _turned(polygon["outer"], x),
                "holes": [_turned(hole, x) for hole in polygon["holes"]],
            }
            for polygon in json.loads(Q)["polygons"]
        ]
    }
    first = _core.PolygonSet.from_json(P).scaled(at).rings()
    second = _core.PolygonSet.from_json(json.dumps(turned)).rings()
    if not (drawable(first) and drawable(second)):
        return None
    layers = [Layer("first clear", first), Layer("second clear", second)]
    if witness.in_truth and witness.p:
        common = [float(Fraction(at) * Fraction(number)) for number in witness.p]
        layers.append(Layer("witness", point=(common[0], common[1])))
        caption = "the witness: sP (blue) and x - Q (ochre) meet in s p"
    else:
        caption = "the witness: sP (blue) and x - Q (ochre) do not meet"
    return Picture(caption, picture(layers, caption))


def _turned(ring: list[list[str]], x: list[Fraction]) -> list[list[str]]:
    return [[str(a - Fraction(b)) for a, b in zip(x, point, strict=True)] for point in ring]


def _faint(layer: Layer) -> Layer:
    return Layer("faint", layer.polygons)


def _difference(missing: Layer, extra: Layer) -> str:
    parts = [
        text
        for layer, text in (
            (missing, "missing from the result (red, hatched /)"),
            (extra, "too much in the result (orange, hatched \\)"),
        )
        if layer.polygons
    ]
    return f"difference: {' and '.join(parts) or 'none as sets of points'}"


def _marks(witness: Witness | None) -> list[Layer]:
    """The witness, and the square of its tolerance."""
    if witness is None:
        return []
    x, y = (approximate(number) for number in witness.point)
    if not (math.isfinite(x) and math.isfinite(y)):
        return []
    half = float(Fraction(witness.tolerance))
    square = [
        (x - half, y - half),
        (x + half, y - half),
        (x + half, y + half),
        (x - half, y + half),
    ]
    marks = [Layer("square", [[square]])] if half else []
    return [*marks, Layer("witness", point=(x, y))]


def _smaller(near: Box, box: Box) -> bool:
    return all(near[k + 2] - near[k] < CLOSE * (box[k + 2] - box[k]) for k in (0, 1))


def _factor(box: Box, near: Box) -> float:
    pad = _padded(near)
    return min((box[k + 2] - box[k]) / max(pad[k + 2] - pad[k], 1e-300) for k in (0, 1))


def _padded(box: Box) -> Box:
    pad = 0.4 * max(box[2] - box[0], box[3] - box[1], 1e-12)
    return (box[0] - pad, box[1] - pad, box[2] + pad, box[3] + pad)
