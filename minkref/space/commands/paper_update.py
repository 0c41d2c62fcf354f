"""The paper's own update in space, in `minkref sum` and `minkref sweep`: its walk, and its answers
beside the exact sums."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager
from fractions import Fraction
from typing import Any, TypeVar

from minkref import _core
from minkref.arithmetic import check_arithmetic
from minkref.cli.output import plain_table
from minkref.cli.progress import Tell, told_of
from minkref.cli.readings import ROUTE, SPACE_CHOICES, readings_of, refuse_options
from minkref.cli.row_spool import Row, RowSpool
from minkref.errors import Refusal, refusing
from minkref.exact import in_double_range, rounded
from minkref.fuzz.judges.plane.rounded_sums import last_place, most_places
from minkref.fuzz.judges.plane.rounded_sums import significant_bits as significant_bits
from minkref.output.terminal import counted
from minkref.plane.commands.scale_index import cores
from minkref.plane.commands.sweep_rows import SHOWN, print_sweep
from minkref.space.operand import SpaceOperand
from minkref.space.scaling import Scaling, text_of
from minkref.verbs.paper_update import decided

T = TypeVar("T")

COUNTS = ("exposed_facets", "rings", "corners", "cells", "asked")
STEPS = ("insertions", "deletions", "updated")


class SpaceWalk:
    """P and Q followed from one scale to another by the paper's program. Each answer is held
    against the exact sum. `telling` opens a line of progress for a piece of work."""

    def __init__(
        self,
        P: SpaceOperand,
        Q: SpaceOperand,
        scale: str,
        arithmetic: str,
        readings: dict[str, str],
        telling: Callable[[str], AbstractContextManager[Tell]] = told_of,
    ) -> None:
        for operand in (P, Q):
            if operand.surface.vertices and not operand.is_solid:
                _refuse_flat(operand)
        self._bits = significant_bits(arithmetic)
        self._where = f"{P.name} and {Q.name}"
        self._telling = telling
        self._update = self._long(
            "crossings of facets at all scales",
            lambda tell: _core.PaperSpaceUpdate(
                P.surface, Q.surface, scale, arithmetic, readings, cores(), tell
            ),
        )

    def preparation(self) -> dict[str, Any]:
        """Counts from the search for events at all scales."""
        counts = self._update.counts()
        return {
            "convolution_facets": counts["facets"],
            **{name: counts[name] for name in ("pairs", "crossings", "events")},
            "undecided_pairs": counts["undecided"],
            "preprocessing_seconds": self._update.seconds,
        }

    def move_to(self, scale: str) -> dict[str, Any]:
        counts, seconds = self._told(lambda: self._update.move_to(scale))
        return {**{name: counts[name] for name in STEPS}, "update_seconds": seconds}

    def answer(self) -> dict[str, Any]:
        """The answer where the walk stands, and how it differs from the exact sum."""
        placed, place_seconds = self._told(self._update.place_intersections)
        found = self._long("cells on the facets", self._update.sum)
        counts = dict(found.counts())
        return {
            "placed": placed,
            "place_seconds": place_seconds,
            **{name: counts.get(name, 0) for name in COUNTS},
            "sum_seconds": found.seconds,
            "exact": self._beside_exact(found),
        }

    def row(self, scaling: Scaling) -> tuple[Row, _core.Polyhedron]:
        """The row of a sweep at its next scale; the surface is empty, for the answer is none."""
        row: Row = {"scale": list(scaling), **self.move_to(scaling[0]), **self.answer()}
        return row, _core.Polyhedron([], [])

    def _beside_exact(self, found: _core.PaperSpaceSum) -> dict[str, Any]:
        bits, limit = self._bits, limit_of(self._bits)
        same, error, coordinate, witness = self._long(
            "the exact sum beside it",
            lambda tell: self._update.beside_exact(found, limit, cores(), tell),
        )
        ulps = None
        if same:
            unit = Fraction(1) if bits is None else last_place(Fraction(coordinate), bits)
            ulps = in_double_range(str(Fraction(error) / unit))
        return {"same_structure": same, "ulps": ulps, "witness": _witness_fields(witness)}

    def _long(self, name: str, work: Callable[[Tell], T]) -> T:
        with self._telling(name) as tell:
            return self._told(lambda: work(tell))

    def _told(self, work: Callable[[], T]) -> T:
        return decided(lambda: refusing(self._where, work))


def limit_of(bits: int | None) -> str:
    """Return the largest error of a corner that counts as none, relative to the largest coordinate,
    for numbers with so many bits (None: exact numbers)."""
    return "0" if bits is None else str(most_places(bits) * last_place(1, bits))


def _refuse_flat(operand: SpaceOperand) -> None:
    raise Refusal(
        "the operand has no volume, and the paper's update (Sec. 5) takes faces of solids",
        operand.name,
        f"give a polyhedron with a volume, or leave out --route {ROUTE}",
        "not-solid",
    )


def _witness_fields(witness: Any) -> dict[str, Any] | None:
    if witness is None:
        return None
    point, (normal, offset), on_boundary = witness
    return {
        "point": list(point),
        "normal": list(normal),
        "offset": offset,
        "on_boundary": on_boundary,
    }


def asked_readings(
    route: str | None, arithmetic: str, form: str | None, chosen: Sequence[str] | None
) -> dict[str, str] | None:
    """How the paper's program reads the paper; None for the other routes, which are exact and have
    no readings."""
    check_arithmetic(arithmetic)
    if route == ROUTE:
        return readings_of(form, chosen, SPACE_CHOICES)
    if arithmetic != "rational":
        mend = f"leave the option out, or add --route {ROUTE}"
        raise Refusal("sums in space are exact only", f"--arithmetic {arithmetic}", mend)
    refuse_options(route or "of an exact sum", form, chosen, SPACE_CHOICES)
    return None


def refuse_axes(scaling: Scaling) -> None:
    """Refuse factors that differ: Section 5 scales uniformly."""
    if len({Fraction(factor) for factor in scaling}) > 1:
        raise Refusal(
            "the update of Sec. 5 of the paper is of uniform scales only",
            f"scaling {text_of(scaling)}",
            "give one factor, or in a sweep of convex operands --repair literal (Sec. 6)",
        )


def refuse_output(given: object) -> None:
    if given is not None:
        raise Refusal(
            "the program answers with facets that need not bound a set: there is no mesh to write",
            f"-o {given}",
            f"leave it out, or leave out --route {ROUTE}",
        )


def in_words(found: dict[str, Any]) -> str:
    """A comparison in words."""
    if found["same_structure"]:
        off = found["ulps"]
        return "the same boundary" if off == 0 else f"the same structure, up to {off:.3g} ulp off"
    witness = found["witness"]
    if witness is None:
        return "another structure"
    where = ", ".join(witness["point"])
    told = "on the boundary, and lost" if witness["on_boundary"] else "not on it, and added"
    plane = " ".join(witness["normal"])
    return f"another structure: ({where}) in the plane across ({plane}) is {told}"


def answer_rows(paper: dict[str, Any]) -> list[tuple[str, str]]:
    """Rows of what people read of an answer."""
    return [
        (
            "facets of the convolution",
            f"{paper['convolution_facets']:,}, in {paper['pairs']:,} pairs",
        ),
        ("crossings, events", f"{paper['crossings']:,}, {paper['events']:,}"),
        ("crossings placed", f"{paper['placed']:,}"),
        (
            "boundary",
            f"{paper['exposed_facets']:,} facets, {paper['rings']:,} rings, "
            f"{paper['corners']:,} corners",
        ),
        ("beside the exact sum", in_words(paper["exact"])),
    ]


def print_sweep_rows(value: dict[str, Any], rows: RowSpool) -> None:
    headings = ("scale", "in", "out", "crossings", "facets", "update µs", "place µs", "sum ms",
                "beside the exact sum")  # fmt: skip
    table = plain_table(*headings, right=headings[:-1], whole=True)
    for row in rows.first(SHOWN):
        table.add_row(
            rounded(row["scale"][0], 8),
            *(f"{row[name]:,}" for name in STEPS),
            f"{row['exposed_facets']:,}",
            *(f"{row[name] * 1e6:,.1f}" for name in ("update_seconds", "place_seconds")),
            f"{row['sum_seconds'] * 1000:,.2f}",
            in_words(row["exact"]),
        )
    summary = [
        ("sweep", f"{value['P']} + {value['Q']}, {counted(len(rows), 'scale')}"),
        ("route", f"{ROUTE}, {value['arithmetic']}"),
        ("seconds", f"{value['seconds']:.3f}"),
    ]
    print_sweep(table, rows, summary, value)
