"""`minkref events P Q`: the critical scales of sP + Q, exact and sorted."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated, Any

import typer
from rich.console import Console

from minkref import _core
from minkref.arithmetic import check_arithmetic
from minkref.documents import (
    Stopwatch,
    as_text,
    check_writable,
    document,
    listing,
    write_atomically,
)
from minkref.errors import Refusal, refusing
from minkref.event_table import write_parquet
from minkref.exact import approximate, read_scale
from minkref.fuzz.least_precision import MOST_BITS, least_precision
from minkref.operand import Operand, read_operand
from minkref.options import Json, Schema
from minkref.terminal import console, lines, shown

EXAMPLES = """Examples:

minkref events disc1 cells1815

minkref events g1 g2 --from 1/2 --to 2 --json

minkref events glyph1204 glyph275 -o events.parquet

minkref events g1 g2 --kind parallel

minkref events g1 g2 --form printed --arithmetic mpfr:53"""

KINDS = ("pair", "parallel")
FORMS = ("corrected", "printed")
OUTPUTS = (".json", ".parquet")
SHOWN = 10  # events that people see
CHUNK = 32768  # events at a time


def command(
    P: Annotated[str, typer.Argument(help="First operand, the scaled one: a file or a model.")],
    Q: Annotated[str, typer.Argument(help="Second operand: a file or a model.")],
    from_scale: Annotated[
        str | None,
        typer.Option("--from", help="Begin of the window, in it. Open to 0 without.", metavar="A"),
    ] = None,
    to_scale: Annotated[
        str | None,
        typer.Option("--to", help="End of the window, in it. Endless without.", metavar="B"),
    ] = None,
    kind: Annotated[
        str,
        typer.Option(
            "--kind",
            help="pair: two edges of the convolution start or stop meeting. "
            "parallel: two parallel edges come to lie on one line.",
        ),
    ] = "pair",
    form: Annotated[
        str,
        typer.Option("--form", help="corrected, or printed: the paper's own rule, often wrong."),
    ] = "corrected",
    arithmetic: Annotated[
        str,
        typer.Option(
            "--arithmetic",
            help="rational (exact), interval, double or mpfr:BITS. All but the first report how "
            "the paper's method fares in them, beside what is true.",
        ),
    ] = "rational",
    least: Annotated[
        bool,
        typer.Option(
            "--least-precision",
            help="Also find the fewest bits of mpfr at which the paper's method gets every event "
            "right (slow).",
        ),
    ] = False,
    output: Annotated[
        Path | None,
        typer.Option("-o", help="Write all events there: .json or .parquet.", metavar="FILE"),
    ] = None,
    json: Json = False,
    schema: Schema = False,
) -> None:
    """All scales at which edges of the reduced convolution start or stop meeting: exact, sorted."""
    watch = Stopwatch()
    _check(kind, form, arithmetic, output)
    window = [
        read_scale(scale, option) if scale is not None else None
        for scale, option in ((from_scale, "--from"), (to_scale, "--to"))
    ]
    first, second = read_operand(P), read_operand(Q)
    where = f"{first.name} and {second.name}"
    found = refusing(
        where, lambda: _core.pair_events(first.set, second.set, window[0], window[1], kind, form)
    )
    trial: dict[str, Any] | None = None
    if arithmetic != "rational":
        trial = dict(
            refusing(where, lambda: _core.precision_trial(first.set, second.set, arithmetic, form))
        )
    counts = dict(found.counts())
    fields: dict[str, Any] = {
        "P": first.name,
        "Q": second.name,
        "from": window[0],
        "to": window[1],
        "kind": kind,
        "form": form,
        "arithmetic": arithmetic,
        "warnings": first.warnings + second.warnings,
        "output": str(output) if output else None,
        "compute_seconds": found.seconds,
        "segments": {"S": counts.pop("s_edges"), "T": counts.pop("t_edges")},
        "signs": {name: counts.pop(name) for name in ("by_float", "by_integer", "by_rational")},
        "kernel": counts.pop("kernel"),
        **counts,
        "trial": trial,
        "least_precision": _least(first, second, form) if least else None,
    }
    if output is not None and output.suffix.lower() == ".parquet":
        write_parquet(found, output)
    elif output is not None:
        value = document("events", watch, **fields)
        write_atomically(output, listing(value, "events", event_list(found)))
    if json and output is None:
        value = document("events", watch, **fields)
        sys.stdout.writelines(listing(value, "events", event_list(found)))
    elif json:
        sys.stdout.write(as_text(document("events", watch, **fields, events=None)))
    else:
        _print(document("events", watch, **fields), found)


def _least(P: Operand, Q: Operand, form: str) -> dict[str, int | None]:
    bits = refusing(f"{P.name} and {Q.name}", lambda: least_precision(P.set, Q.set, form))
    return {"bits": bits, "most_tried": MOST_BITS}


def event_list(found: _core.PairEvents) -> Iterator[dict[str, Any]]:
    """Every event as the published schema has it; progress on a terminal."""
    from rich.progress import Progress

    edges = [_edge(row) for row in found.edges()]
    with Progress(
        console=Console(stderr=True), transient=True, disable=not sys.stderr.isatty()
    ) as progress:
        task = progress.add_task("events", total=len(found))
        for first in range(0, len(found), CHUNK):
            yield from (_event(row, edges) for row in found.rows(first, first + CHUNK))
            progress.update(task, completed=first + CHUNK)


def _edge(row: tuple[Any, ...]) -> dict[str, Any]:
    kind, _, edge_ring, edge, vertex_ring, vertex = row
    return {"kind": kind, "edge": [edge_ring, edge], "vertex": [vertex_ring, vertex]}


def _event(row: tuple[Any, ...], edges: list[dict[str, Any]]) -> dict[str, Any]:
    scale, rank, change, parallel, a, b, at, to = row
    return {
        "s": scale,
        "rank": rank,
        "kind": "parallel" if parallel else "pair",
        "change": change,
        "parents": [edges[a], edges[b]],
        "at": list(at),
        "to": list(to) if to else None,
    }


def _check(kind: str, form: str, arithmetic: str, output: Path | None) -> None:
    if kind not in KINDS:
        raise Refusal(
            f"there is no kind {kind!r} of events", "--kind", f"choose one of {', '.join(KINDS)}"
        )
    if form not in FORMS:
        raise Refusal(f"there is no form {form!r}", "--form", f"choose one of {', '.join(FORMS)}")
    check_arithmetic(arithmetic)
    if arithmetic != "rational" and kind != "pair":
        raise Refusal(
            "other arithmetics are tried on pair events",
            f"--kind {kind} --arithmetic {arithmetic}",
            "leave out one of the two options",
        )
    if output is None:
        return
    if output.suffix.lower() not in OUTPUTS:
        raise Refusal(
            f"the ending {output.suffix or '(none)'} names no format that can be written",
            str(output),
            f"choose one of {', '.join(OUTPUTS)}",
        )
    check_writable(output)


def _print(value: dict[str, Any], found: _core.PairEvents) -> None:
    window = f"[{value['from'] or '0'}, {value['to'] or 'oo'}]"
    if value["from"] is None:
        window = "(" + window[1:]
    if value["to"] is None:
        window = window[:-1] + ")"
    segments, signs = value["segments"], value["signs"]
    total = sum(signs.values())
    rows = [
        (f"{value['kind']} events", f"{value['P']} + {value['Q']}, s in {window}"),
        ("form", value["form"]),
        ("edges", f"{segments['S']:,} S-edges, {segments['T']:,} T-edges"),
        ("pairs", f"{value['pairs']:,}; {value['filtered_pairs']:,} filtered by floats"),
    ]
    if value["kind"] == "pair":
        rows += [
            (
                "meeting",
                f"{value['intersecting_pairs']:,}, of them {value['always_meeting_pairs']:,} at "
                f"every scale; {value['touching_pairs']:,} more only touch",
            )
        ]
    else:
        rows += [("on one line", f"{value['parallel_pairs']:,}")]
    rows += [("events", f"{value['count']:,} at {value['distinct']:,} scales")]
    if total:
        rows += [("signs", f"{total:,}: {signs['by_float'] / total:.2%} by float")]
    if value["least_precision"] is not None:
        rows += [("least precision", _least_text(value["least_precision"]))]
    rows += [("seconds", f"{value['seconds']:.3f}")]
    if value["output"]:
        rows += [("written", value["output"])]
    sys.stdout.write(lines(rows))
    if value["trial"] is not None:
        sys.stdout.write("\n" + lines(_trial_rows(value["arithmetic"], value["trial"])))
    if value["output"] is None and value["trial"] is None:
        _print_first(found)
    for warning in value["warnings"]:
        sys.stderr.write(f"warning: {shown(warning)}\n")


def _least_text(found: dict[str, int | None]) -> str:
    if found["bits"] is not None:
        return f"{found['bits']} bits: the paper's method gets every event right"
    return f"none up to {found['most_tried']:,} bits: some events only exact arithmetic can tell"


def _trial_rows(arithmetic: str, trial: dict[str, Any]) -> list[tuple[str, str]]:
    return [
        ("the paper's method in", arithmetic),
        ("undecided pairs", f"{trial['undecided_pairs']:,} of {trial['pairs']:,}"),
        ("called inconsistent", f"{trial['false_inconsistent']:,} of {trial['roots']:,} solves"),
        ("events missed", f"{trial['missed']:,} of {trial['events']:,}"),
        ("events invented", f"{trial['invented']:,}"),
        ("off by over an ulp", f"{trial['misplaced']:,}"),
        ("in the wrong order", f"{trial['inversions']:,} pairs of events"),
        ("merged scales", f"{trial['merged']:,}"),
    ]


def _print_first(found: _core.PairEvents) -> None:
    from rich.table import Table

    if len(found) == 0:
        return
    table = Table("s", "about", "change", "edges", "at")
    edges = found.edges()
    for scale, _, change, _, a, b, at, _ in found.rows(0, SHOWN):
        where = ", ".join(f"{approximate(x):.6g}" for x in at)
        kinds = f"{edges[a][0]} {a}, {edges[b][0]} {b}"
        table.add_row(scale, f"{approximate(scale):.6g}", change, kinds, f"({where})")
    sys.stdout.write("\n")
    console().print(table)
    if len(found) > SHOWN:
        sys.stdout.write(f"{len(found) - SHOWN:,} more: --json or -o FILE gives all\n")
