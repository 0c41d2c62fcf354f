"""The tolerance, layer, warnings, numbers and refusals of all readers of drawings."""

from __future__ import annotations

import shlex
from collections import Counter
from dataclasses import dataclass, field
from fractions import Fraction

from minkref.drawings.curves import TooFine
from minkref.errors import Refusal, choice
from minkref.exact import read_number
from minkref.repair.weld import Vector

LONGEST = 200  # characters of a number


@dataclass
class Reading:
    """A file under reading. `weld`: join line ends nearer than this; `layers`: all names
    met; `left_out`: counts by skipped kind; `moves`: ends that moved, with their new places."""

    source: str
    tolerance: Fraction | None = None
    layer: str | None = None
    weld: Fraction | None = None
    layers: dict[str, None] = field(default_factory=dict)
    left_out: Counter[str] = field(default_factory=Counter)
    notes: dict[str, None] = field(default_factory=dict)
    moves: dict[Vector, Vector] = field(default_factory=dict)

    def number(self, text: str) -> Fraction:
        """Read a decimal exactly. Refuses NaN, infinity and other words."""
        if len(text) > LONGEST:
            raise self.refusal("a number is too long", "write fewer digits", "number-too-long")
        mend = "write a finite decimal, as 0.1 or 1e-3"
        return read_number(text.strip(), "coordinate", self.source, mend)

    def note(self, text: str) -> None:
        self.notes[text] = None

    def curve_tolerance(self) -> Fraction:
        """Refuses a curve if nobody has said how far polygons may be off."""
        if self.tolerance is None:
            file = shlex.quote(self.source)
            raise self.refusal(
                "the drawing has arcs or curves, and a set has corners",
                f"make polygons of them: `minkref repair {file} --tolerance 1/100 -o FILE.json`, "
                "with the distance by which they may be off",
                "no-tolerance",
            )
        self.note(
            f"curves became polylines within {self.tolerance}: corners lie on them, to a hundredth "
            "of that"
        )
        return self.tolerance

    def takes(self, layer: str) -> bool:
        """Tell whether to read a layer's entities."""
        self.layers[layer] = None
        return self.layer is None or self.layer == layer

    def refusal(self, what: str, mend: str, code: str, where: str = "") -> Refusal:
        return Refusal(what, f"{self.source}, {where}" if where else self.source, mend, code)

    def too_fine(self, error: TooFine, where: str) -> Refusal:
        mend = "give a larger tolerance, or correct the radius"
        return self.refusal(str(error), mend, "too-many-vertices", where)

    def check_layer(self) -> None:
        """Refuse a layer that the drawing does not have."""
        if self.layer is not None and self.layer not in self.layers:
            mend = choice(self.layer, self.layers) if self.layers else "leave the option out"
            raise Refusal(f"there is no layer {self.layer[:40]!r}", "--layer", mend)

    def warnings(self) -> list[str]:
        found = list(self.notes)
        if self.left_out:
            listed = ", ".join(f"{count} {kind}" for kind, count in sorted(self.left_out.items()))
            found.append(f"left out: {listed}")
        if self.layer is None and len(self.layers) > 1:
            found.append(f"layers are read together: {', '.join(self.layers)}")
        return [f"{self.source}: {text}" for text in found]
