"""The pictures of a case in space: operands, expected, got, and both with the witness."""

from __future__ import annotations

from fractions import Fraction

from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import scale_of
from minkref.fuzz.run.naming import load
from minkref.fuzz.run.worker import CaseResult
from minkref.fuzz.space.case import SpaceCase
from minkref.fuzz.verdicts.verdict import Outcome
from minkref.reports.conformance.argument import point_text
from minkref.reports.conformance.plane_pictures import Picture
from minkref.reports.conformance.solid_axes import axes_around, box_around
from minkref.reports.conformance.solid_drawing import place_of, projected, solid_layers, wire_layer
from minkref.reports.drawing import Label, Layer, picture


def expected_in_space(case: CaseResult) -> Polyhedron | None:
    """The exact sum if known for the pair; None if only points are known."""
    try:
        loaded = load(CaseName(case.literal or case.name.text, "report"))
        named = load(case.name)
    except Exception:  # noqa: BLE001 a picture is no reason for a report to fail
        return None
    for each in (named, loaded):
        if isinstance(each, SpaceCase):
            try:
                known = each.pair.sum()
            except ValueError:
                known = None
            if known is not None:
                return known
    return None


def box_of_sum(P: Polyhedron, Q: Polyhedron, scale: str) -> Polyhedron:
    """The box around the sum: sP's box plus Q's box."""
    (a, b), (c, d) = P.scaled(scale_of(scale)).box, Q.box
    low, high = (
        [m + n for m, n in zip(a, c, strict=True)],
        [m + n for m, n in zip(b, d, strict=True)],
    )
    corners = tuple(
        (x, y, z) for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])
    )
    faces = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
    return Polyhedron(corners, faces)


def space_operand_pictures(P: Polyhedron, Q: Polyhedron, scale: str) -> list[Picture]:
    scaled = "" if scale == "1" else f", to be scaled by {scale}"
    found = []
    for name, solid, style in (("P", P, "first"), ("Q", Q, "second")):
        layers = solid_layers(solid, style)
        if layers is not None:
            caption = f"{name}{scaled if name == 'P' else ''}"
            layers = [*layers, *axes_around([solid])]
            found.append(Picture(caption, picture(layers, caption, 280, box_around(layers))))
    return found


def space_comparison_pictures(
    P: Polyhedron, Q: Polyhedron, case: CaseResult, outcome: Outcome
) -> list[Picture]:
    """All in one frame."""
    known = expected_in_space(case)
    wanted = known or box_of_sum(P, Q, case.scale)
    shown = solid_layers(wanted, "sum") if known else None
    frame = wire_layer(wanted, "wire")
    caption = "expected" if known else "expected: the box of the sum, which is decided by points"
    groups: list[tuple[str, list[Layer]]] = []
    solids = [wanted]
    if shown is not None:
        groups.append((caption, shown))
    elif frame is not None:
        groups.append((caption, [frame]))
    if outcome.got is not None:
        result = Polyhedron.from_json(outcome.got)
        solids.append(result)
        got = solid_layers(result, "got")
        lines = wire_layer(result, "wire-got")
        if got is not None and lines is not None:
            groups.append((f"got from {outcome.target}", got))
            both = [layer for layer in (frame, lines) if layer is not None]
            groups.append(("both: expected green, got violet and dashed", both))
    witness = outcome.witness
    place = place_of(witness.point) if witness else None
    marks = []
    points = []
    if witness is not None and place is not None:
        label = Label(projected(place), point_text(witness.point), "middle", (0.0, -8.0))
        marks = [Layer("witness", point=projected(place), labels=[label])]
        x, y, z = (Fraction(number) for number in witness.point)
        points = [(x, y, z)]
    axes = axes_around(solids, points)
    box = box_around([*(layer for _, layers in groups for layer in layers), *axes, *marks])
    return [
        Picture(
            text,
            picture([*layers, *axes, *marks], text, box=box),
            picture([*layers, *(Layer(mark.style, point=mark.point) for mark in marks)], text),
        )
        for text, layers in groups
    ]
