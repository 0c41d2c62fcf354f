"""An adapter that finds concave features, in a way that the argument names.

right          by the reference: bars exact, bridges as doubles
turned         the same, bars and bridges in another order, ends swapped
rounded        in doubles, within its tolerance
bars           bars alone

All others have one fault each: FAULTS.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.fuzz.features.true_features import TrueFeatures

ALL = "plane non-convex holes components touching point segment empty rational features".split()
TOLERANCE = "1e-9"
Value = dict[str, Any]
Set = _core.PolygonSet


def answer(P: Set, radius: Fraction) -> Value:
    found: Value = json.loads(TrueFeatures(P).answer(radius))
    return found


def near(radius: Any) -> Any:
    """A radius as a double."""
    if radius is None:
        return None
    if isinstance(radius, dict):
        return float(Fraction(radius["square"])) ** 0.5
    return float(Fraction(radius[0] if isinstance(radius, list) else radius))


def doubles(value: Value) -> Value:
    bars = [[near(end) for end in bar] for bar in value["bars"]]
    chords = [[[float(Fraction(x)) for x in end] for end in c] for c in value["bridges"]]
    return {**value, "bars": bars, "bridges": chords}


def with_bars(change: Callable[[list[Any]], list[Any]]) -> Callable[[Set, Fraction], Value]:
    """The reference's answer in doubles, bars changed."""

    def changed(P: Set, radius: Fraction) -> Value:
        value = doubles(answer(P, radius))
        return {**value, "bars": change(value["bars"])}

    return changed


def with_bridges(change: Callable[[list[Any]], list[Any]]) -> Callable[[Set, Fraction], Value]:
    def changed(P: Set, radius: Fraction) -> Value:
        value = doubles(answer(P, radius))
        return {**value, "bridges": change(value["bridges"])}

    return changed


def at_other(factor: Fraction) -> Callable[[Set, Fraction], Value]:
    """Bridges and counts of another radius."""
    return lambda P, radius: doubles(answer(P, radius * factor))


def of_other(change: Callable[[Set], Set]) -> Callable[[Set, Fraction], Value]:
    return lambda P, radius: doubles(answer(change(P), radius))


def without_holes(P: Set) -> Set:
    return Set(P.rings() and [[polygon[0]] for polygon in P.rings()])


def first_polygon(P: Set) -> Set:
    return Set(P.rings()[:1])


def times(factor: float, bars: list[Any]) -> list[Any]:
    return [[b * factor, d if d is None else d * factor] for b, d in bars]


def squared(bars: list[Any]) -> list[Any]:
    return [[b * b, d if d is None else d * d] for b, d in bars]


def once(bars: list[Any]) -> list[Any]:
    """Ties as one."""
    return [json.loads(text) for text in sorted({json.dumps(bar) for bar in bars})]


def ended(bars: list[Any]) -> list[Any]:
    """Bars without an end stop at the greatest radius."""
    last = max((d for _, d in bars if d is not None), default=1.0)
    return [[b, last if d is None else d] for b, d in bars]


def younger(bars: list[Any]) -> list[Any]:
    """Younger features live on: births of all bars in turn."""
    births = [b for b, _ in bars]
    return [[b, d] for b, (_, d) in zip([*births[1:], *births[:1]], bars, strict=True)]


def coarse(bars: list[Any]) -> list[Any]:
    return [[float(f"{b:.3g}"), d if d is None else float(f"{d:.3g}")] for b, d in bars]


def shifted(chords: list[Any]) -> list[Any]:
    """Moves one end of a bridge a little."""
    if not chords:
        return chords
    (a, b), *rest = chords
    return [[a, [b[0] + (b[0] - a[0]) / 1000, b[1] + (b[1] - a[1]) / 1000]], *rest]


def no_holes(P: Set, radius: Fraction) -> Value:
    return {**doubles(answer(P, radius)), "holes": 0}


def one_component(P: Set, radius: Fraction) -> Value:
    return {**doubles(answer(P, radius)), "components": 1}


Way = Callable[[Set, Fraction], Value]
FAULTS: dict[str, Way] = {
    "lost-bar": with_bars(lambda bars: bars[1:]),
    "one-more": with_bars(lambda bars: [*bars, [0.0, 1.0]]),
    "diameters": with_bars(lambda bars: times(2, bars)),
    "squares": with_bars(squared),
    "ties-once": with_bars(once),
    "no-infinity": with_bars(ended),
    "no-minima": with_bars(lambda bars: [bar for bar in bars if bar[0] == 0]),
    "from-zero": with_bars(lambda bars: [[0.0, d] for _, d in bars]),
    "younger": with_bars(younger),
    "coarse": with_bars(coarse),
    "ignores-holes": of_other(without_holes),
    "first-polygon": of_other(first_polygon),
    "lost-bridge": with_bridges(lambda chords: chords[1:]),
    "bridge-twice": with_bridges(lambda chords: [*chords, *chords[:1]]),
    "moved-bridge": with_bridges(shifted),
    "early-bridges": at_other(Fraction(9, 10)),
    "no-holes": no_holes,
    "one-component": one_component,
}


def turned(P: Set, radius: Fraction) -> Value:
    value = answer(P, radius)
    return {**value, "bars": value["bars"][::-1], "bridges": [c[::-1] for c in value["bridges"]]}


def rounded(P: Set, radius: Fraction) -> Value:
    value = doubles(answer(P, radius))
    return {**value, "bars": times(1 + 1e-11, value["bars"])}


WAYS: dict[str, Way] = {
    **FAULTS,
    "right": answer,
    "turned": turned,
    "rounded": rounded,
    "bars": lambda P, radius: {"bars": answer(P, radius)["bars"]},
}
EXACT = ("right", "turned", "bars")


def read(value: Any) -> Set:
    return Set.from_json(json.dumps(texts(value)))


def texts(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: texts(one) for key, one in value.items()}
    return [texts(one) for one in value] if isinstance(value, list) else str(Fraction(value))


def told(value: Any) -> Any:
    """Doubles as texts."""
    if isinstance(value, dict):
        return {key: told(one) for key, one in value.items()}
    if isinstance(value, list):
        return [told(one) for one in value]
    return str(Fraction(value)) if isinstance(value, float) else value


def answer_to(way: str, request: Value) -> Value:
    found: Value = told(WAYS[way](read(request["P"]), Fraction(request["radius"])))
    return found


def main(way: str) -> None:
    hello: Value = {"name": way, "version": "1", "sum": "none", "capabilities": ALL}
    if way not in EXACT:
        hello |= {"arithmetic": "float64", "tolerance": {"relative": TOLERANCE}}
    for line in sys.stdin:
        request = json.loads(line)
        reply: Value = {"seq": request["seq"], "status": "result"}
        if request["verb"] == "hello":
            reply |= {"protocol": "adapter-v1", **hello}
        elif request["verb"] == "features":
            reply |= answer_to(way, request)
        elif request["verb"] != "stop":
            reply |= {"status": "skipped", "reason": "no such verb"}
        print(json.dumps(reply), flush=True)


if __name__ == "__main__":
    main(sys.argv[1])
