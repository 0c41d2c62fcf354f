"""Pictures of a case in the plane: operands, expected, got, difference, and the witness, where sP
and x - Q meet or miss. Numbers stay exact until the frame places them, so that sets of any size and
cracks of any thickness show."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction

from minkref import _core
from minkref.fuzz.verdicts.verdict import Outcome, Witness
from minkref.plane.exact_frame import (
    Exact,
    ExactBox,
    ExactPolygons,
    Frame,
    box_of,
    exact_polygons,
    fitted,
)
from minkref.reports.axes import rounded
from minkref.reports.conformance.close_up import clipped, close_up
from minkref.reports.drawing import Box, Label, Layer, picture

PANE = 340
SMALL = 280  # for an operand
LONGEST = 8  # characters of a coordinate beside its point
LEFT = Fraction(1, 3)  # of the picture: a text beside a point there goes on to the right

Set = tuple[str, ExactPolygons]  # with its style


@dataclass(frozen=True)
class Picture:
    """`small`: the picture without axes, for narrow places."""

    caption: str
    svg: str
    small: str = ""


def operand_pictures(P: str, Q: str, scale: str) -> list[Picture]:
    scaled = "" if scale == "1" else f", to be scaled by {scale}"
    found = []
    for name, text, style in (("P", P, "first"), ("Q", Q, "second")):
        caption = f"{name}{scaled if name == 'P' else ''}"
        found.append(_drawn([(style, _exact(text))], caption, width=SMALL))
    return found


def set_pictures(named: Iterable[tuple[str, str]]) -> list[Picture]:
    """Each set by its name and text, in a picture of its own."""
    return [_drawn([("first", _exact(text))], name, width=SMALL) for name, text in named]


def comparison_pictures(expected: str, outcome: Outcome, drawn: str | None = None) -> list[Picture]:
    """Expected, got and difference in one frame, the witness marked; a close-up if the difference
    is small or thin. `drawn`: the polygons to draw instead of what the outcome has."""
    wanted, answer = _exact(expected), drawn or outcome.got
    groups: list[tuple[str, list[Set]]] = [("expected", [("sum", wanted)])]
    differing: list[Set] = []
    if answer is not None:
        right, got = map(_core.PolygonSet.from_json, (expected, answer))
        differing = [
            ("missing", exact_polygons(_core.minus(right, got))),
            ("extra", exact_polygons(_core.minus(got, right))),
        ]
        groups.append((f"got from {outcome.target}", [("got", _exact(answer))]))
        groups.append((_difference(differing), [("faint", wanted), *differing]))
    witness = outcome.witness
    marked = (witness, _place(witness.point)) if witness else None
    shown = [polygon for _, sets in groups for _, each in sets for polygon in each]
    whole = _box([*shown, *([[[marked[1]]]] if marked else [])])
    pictures = [_drawn(sets, caption, whole, marked) for caption, sets in groups]
    window = close_up(
        [polygon for _, polygons in differing for polygon in polygons],
        whole,
        marked[1] if marked else None,
    )
    if window is not None:
        factor = max(whole[2] - whole[0], whole[3] - whole[1]) / (window[2] - window[0])
        caption = f"the difference, {_times(factor)} times larger"
        sets = [(style, clipped(each, window)) for style, each in [("faint", wanted), *differing]]
        pictures.append(_drawn(sets, caption, window, marked))
    return pictures


def meeting_picture(P: str, Q: str, scale: str, witness: Witness) -> Picture:
    """sP and x - Q: a common point, or none."""
    at = witness.scale or scale
    x = _place(witness.point)
    first = exact_polygons(_core.PolygonSet.from_json(P).scaled(at))
    second = [
        [[(x[0] - a, x[1] - b) for a, b in ring] for ring in polygon] for polygon in _exact(Q)
    ]
    sets = [("first clear", first), ("second clear", second)]
    if witness.in_truth and witness.p:
        p = _place(witness.p)
        common = (Fraction(at) * p[0], Fraction(at) * p[1])
        caption = "the witness: sP (blue) and x - Q (ochre) meet in s p"
        return _drawn(sets, caption, None, (None, common))
    return _drawn(sets, "the witness: sP (blue) and x - Q (ochre) do not meet")


def placed_picture(part: str, obstacles: str, witness: Witness) -> Picture:
    """The part at the scale and the place of a witness among the obstacles."""
    x = _place(witness.point)
    own = exact_polygons(_core.PolygonSet.from_json(part).scaled(witness.scale or "1"))
    moved = [[[(x[0] + a, x[1] + b) for a, b in ring] for ring in polygon] for polygon in own]
    sets = [("second clear", _exact(obstacles)), ("first clear", moved)]
    caption = f"the part (blue) at the scale {witness.scale} at the place of the witness"
    common = _place(witness.q) if witness.q else None
    return _drawn(sets, caption, None, (None, common) if common else None)


def _drawn(
    sets: list[Set],
    caption: str,
    window: ExactBox | None = None,
    marked: tuple[Witness | None, Exact] | None = None,
    width: int = PANE,
) -> Picture:
    """Draws everything in one frame: the window, else the box around all sets."""
    window = window or _box([polygon for _, polygons in sets for polygon in polygons])
    frame = fitted(window, width, width)
    box: Box = (
        0.0,
        0.0,
        float((window[2] - window[0]) * frame.factor),
        float((window[3] - window[1]) * frame.factor),
    )
    layers = [Layer(style, frame.polygons(polygons)) for style, polygons in sets]
    marks = _marks(*marked, window, frame) if marked else []
    plain = [Layer(mark.style, mark.polygons, point=mark.point) for mark in marks]
    return Picture(
        caption,
        picture([*layers, *marks], caption, width, box, frame),
        picture([*layers, *plain], caption, width, box),
    )


def _marks(witness: Witness | None, at: Exact, window: ExactBox, frame: Frame) -> list[Layer]:
    """A point with coordinates, and the square of a witness's tolerance."""
    found = []
    half = Fraction(witness.tolerance) if witness else Fraction(0)
    if half:
        square = (at[0] - half, at[1] - half, at[0] + half, at[1] + half)
        corners = [[(square[i], square[j]) for i, j in ((0, 1), (2, 1), (2, 3), (0, 3))]]
        found.append(Layer("square", frame.polygons(clipped([corners], window))))
    if all(window[k] <= at[k] <= window[k + 2] for k in (0, 1)):
        ((place,),) = frame.polygons([[[at]]])[0]
        part = (at[0] - window[0]) / (window[2] - window[0] or 1)
        anchor, across = ("start", 7.0) if part < LEFT else ("end", -7.0)
        if LEFT <= part <= 1 - LEFT:
            anchor, across = "middle", 0.0
        label = Label(place, _written(at), anchor, (across, -8.0))
        found.append(Layer("witness", point=place, labels=[label]))
    return found


def _written(at: Exact) -> str:
    texts = [str(number) for number in at]
    if all(len(text) <= LONGEST for text in texts):
        return f"({', '.join(texts)})"
    return f"≈ ({', '.join(rounded(number, 4) for number in at)})"


def _exact(text: str) -> ExactPolygons:
    return exact_polygons(_core.PolygonSet.from_json(text))


def _place(point: Iterable[str]) -> Exact:
    x, y = (Fraction(number) for number in point)
    return x, y


def _box(polygons: ExactPolygons) -> ExactBox:
    """A unit square around nothing; not a point."""
    box = box_of(polygons) or (Fraction(0), Fraction(0), Fraction(1), Fraction(1))
    if box[0] == box[2] and box[1] == box[3]:
        return (box[0] - 1, box[1] - 1, box[2] + 1, box[3] + 1)
    return box


def _difference(differing: list[Set]) -> str:
    words = {
        "missing": "missing from the result (red, hatched /)",
        "extra": "too much in the result (orange, hatched \\)",
    }
    parts = [words[style] for style, polygons in differing if polygons]
    return f"difference: {' and '.join(parts) or 'none as sets of points'}"


def _times(factor: Fraction) -> str:
    if factor < 10**6:
        return f"{float(factor):,.0f}"
    return f"10^{len(str(int(factor))) - 1}"
