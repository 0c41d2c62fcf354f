"""`minkref sweep P Q`: the sums at many scales, each got from the one before."""

from __future__ import annotations

import sys
from fractions import Fraction
from pathlib import Path
from typing import Annotated, Any

import typer
from rich.table import Table

from minkref import _core
from minkref.documents import Stopwatch, as_text, document
from minkref.errors import Refusal, refusing
from minkref.exact import approximate, read_scale
from minkref.operand import Operand, read_operand
from minkref.options import Json, Schema
from minkref.progress import progress
from minkref.scales import MOST_SCALES, evenly_spaced, read_scales
from minkref.signals import ending_in_order, interruptible
from minkref.space.operand import in_space
from minkref.space.sweep_command import sweep_in_space
from minkref.sum_fields import sum_fields
from minkref.sweep_folder import FORMATS, INDEX, SweepFolder
from minkref.terminal import console, counted, lines, shown

EXAMPLES = """Examples:

minkref sweep g1 g2 --from 1/2 --to 2 --steps 16

minkref sweep disc1 cells1815 --from 1 --to 2 --steps 11 -o sums --format svg

minkref sweep P.wkt Q.wkt --scales scales.txt --json

minkref sweep gs3 rod --scales scalings.txt -o sums --format off"""

Row = dict[str, Any]


def command(
    P: Annotated[str, typer.Argument(help="First operand, the scaled one: a file or a model.")],
    Q: Annotated[str, typer.Argument(help="Second operand: a file or a model.")],
    from_scale: Annotated[
        str | None, typer.Option("--from", help="The first scale.", metavar="A")
    ] = None,
    to_scale: Annotated[
        str | None,
        typer.Option("--to", help="The last scale; it may be the smaller one.", metavar="B"),
    ] = None,
    steps: Annotated[
        int | None,
        typer.Option(
            "--steps",
            help="How many scales, evenly spaced, the first and the last included.",
            metavar="N",
        ),
    ] = None,
    scales_file: Annotated[
        Path | None,
        typer.Option(
            "--scales",
            help="Take the scales from a file instead: one a line, in any order; in space "
            "SX,SY,SZ.",
            metavar="FILE",
        ),
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option("-o", help=f"Write a file for each scale, and {INDEX}.", metavar="DIR"),
    ] = None,
    form: Annotated[
        str | None,
        typer.Option("--format", help=f"Of these files: {', '.join(FORMATS)}; json by default."),
    ] = None,
    json: Json = False,
    schema: Schema = False,
) -> None:
    """The sums at many scales: all events between the least and the greatest are found once, then
    each sum is got from the one before by dynamic update. Exact, in canonical form."""
    if in_space(P, Q):
        sweep_in_space(P, Q, scales_file, _given(from_scale, to_scale, steps), output, form, json)
        return
    watch = Stopwatch()
    scales = _scales(from_scale, to_scale, steps, scales_file)
    if form is not None and output is None:
        raise Refusal(
            "there are no files without -o", f"--format {form}", "add -o DIR, or leave out --format"
        )
    form = form or "json"
    folder = _folder(output, form)
    first, second = read_operand(P), read_operand(Q)
    if folder is not None:
        folder.check_spares([first.file, second.file])
    with ending_in_order(), progress(len(scales)) as line:
        line.now("finding all events")
        moving = dynamic_sum(first, second, scales)
        rows: list[Row] = []
        for number, scale in enumerate(scales, start=1):
            line.now(f"scale {shown(scale)[:20]}")
            row, region = step(moving, scale)
            row["file"] = row["file_exact"] = None
            if folder is not None:
                row["file"] = folder.name(number)
                row["file_exact"] = _core.writes_exactly(region, form)
                folder.write(row["file"], _text(region, form, row["file"]))
            rows.append(row)
            line.done()
        value = document(
            "sweep",
            watch,
            P=first.name,
            Q=second.name,
            warnings=first.warnings + second.warnings,
            output=str(output) if output else None,
            format=form if output else None,
            preprocessing_seconds=moving.seconds,
            statistics=dict(moving.counts()),
            rows=rows,
        )
        if folder is not None:
            folder.write(INDEX, as_text(value))
    if json:
        sys.stdout.write(as_text(value))
    else:
        _print(value)


def dynamic_sum(P: Operand, Q: Operand, scales: list[str]) -> _core.DynamicSum:
    """All events of the least window that holds the scales; it stands at none of them yet."""
    least, greatest = min(scales, key=Fraction), max(scales, key=Fraction)
    with interruptible():
        return refusing(
            f"{P.name} and {Q.name}", lambda: _core.DynamicSum(P.set, Q.set, least, greatest)
        )


def step(moving: _core.DynamicSum, scale: str) -> tuple[Row, _core.PolygonSet]:
    """Moves to a scale: what the step did, and the sum there."""
    did = dict(moving.move_to(scale))
    answer = moving.sum()
    row: Row = {
        "scale": scale,
        **sum_fields(answer),
        "insertions": did["insertions"],
        "deletions": did["deletions"],
        "swaps": did["swaps"],
        "updated": did["updated"],
        "event_scales": did["groups"],
        "update_seconds": did["seconds"],
        "sum_seconds": answer.seconds,
    }
    return row, answer.region


def _text(region: _core.PolygonSet, form: str, name: str) -> str:
    return refusing(name, lambda: _core.write(region, form))


def _given(first: str | None, last: str | None, steps: int | None) -> list[str]:
    options = (("--from", first), ("--to", last), ("--steps", steps))
    return [option for option, value in options if value is not None]


def _scales(first: str | None, last: str | None, steps: int | None, file: Path | None) -> list[str]:
    given = _given(first, last, steps)
    if file is not None:
        if given:
            raise Refusal(
                "the scales are given twice",
                f"--scales and {', '.join(given)}",
                "leave out --scales, or --from, --to and --steps",
            )
        return read_scales(file)
    if first is None or steps is None or (last is None and steps != 1):
        needed = (("--from", first), ("--to", last), ("--steps", steps))
        missing = ", ".join(option for option, value in needed if value is None)
        raise Refusal(
            f"it is not said which scales: {missing} missing",
            f"minkref sweep {' '.join(given)}".rstrip(),
            "give --from A --to B --steps N, or --scales FILE",
        )
    if not 1 <= steps <= MOST_SCALES:
        raise Refusal(
            f"there must be 1 to {MOST_SCALES:,} scales", f"--steps {steps}", "choose another N"
        )
    begin = read_scale(first, "--from")
    end = read_scale(last, "--to") if last is not None else begin
    return evenly_spaced(begin, end, steps)


def _folder(output: Path | None, form: str) -> SweepFolder | None:
    if form not in FORMATS:
        raise Refusal(
            f"there is no format {form!r}", "--format", f"choose one of {', '.join(FORMATS)}"
        )
    return SweepFolder(output, form) if output is not None else None


def _print(value: dict[str, Any]) -> None:
    table = Table(box=None, pad_edge=False)
    for heading in (
        "scale", "area", "components", "holes", "vertices",
        "insertions", "deletions", "swaps", "updated", "ms",
    ):  # fmt: skip
        table.add_column(heading, justify="right", no_wrap=True)
    for row in value["rows"]:
        counts = (row[name] for name in ("components", "holes", "vertices"))
        did = (row[name] for name in ("insertions", "deletions", "swaps", "updated"))
        seconds = row["update_seconds"] + row["sum_seconds"]
        table.add_row(
            _short(row["scale"]),
            _short(row["area"]),
            *(f"{count:,}" for count in (*counts, *did)),
            f"{seconds * 1000:.3f}",
        )
    out = console()
    out.print(table)
    summary = [
        ("sweep", f"{value['P']} + {value['Q']}, {counted(len(value['rows']), 'scale')}"),
        ("all events", f"{value['preprocessing_seconds']:.3f} s"),
        ("seconds", f"{value['seconds']:.3f}"),
    ]
    if value["output"]:
        summary.append(("written", value["output"]))
    sys.stdout.write("\n" + lines(summary))
    for warning in value["warnings"]:
        sys.stderr.write(f"warning: {shown(warning)}\n")


def _short(number: str) -> str:
    return number if len(number) <= 12 else f"{approximate(number):.10g}"
