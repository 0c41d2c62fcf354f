"""`minkref events P Q`: the critical scales of sP + Q, exact and sorted."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated, Any

import typer
from minkref import _core
from minkref.cli.arithmetic import check_arithmetic
from minkref.cli.memory import SMALLER, Memory, memory_wall
from minkref.cli.options import FirstOperand, Json, Schema, SecondOperand, WindowFrom, WindowTo
from minkref.cli.paper_words import events_in_words, print_literal
from minkref.cli.progress import progress
from minkref.cli.readings import PLANE_CHOICES, readings_of
from minkref.disc.disc import is_disc
from minkref.errors import Refusal, choice, refusing
from minkref.exact import read_window, rounded
from minkref.output.documents import Stopwatch, as_text, document, refuse_overwriting
from minkref.output.output_target import Target, target_of
from minkref.output.terminal import console, counted, escaped, lines
from minkref.plane.commands.event_output import FORMATS, document_pieces, print_pieces, write_events
from minkref.plane.commands.scale_index import (
    IndexFile,
    chosen_route,
    index_of,
    refuse_overwriting_index,
)
from minkref.plane.event_lists import BoundaryEventList, EventList, PairEventList, find_events
from minkref.plane.event_values import FORMS, KINDS, PAIR_KINDS, ROUTED_KINDS, ROUTES
from minkref.plane.operand import Operand, read_operand
from minkref.space.operand import in_space

EXAMPLES = """Examples:

minkref events disc1 cells1815

minkref events g1 g2 --from 1/2 --to 2 --json

minkref events glyph1204 glyph275 -o events.parquet

minkref events g1 g2 --kind arrangement --from 1 --to 3/2 -o events.json

minkref events disc1 cells1815 --kind topology --from 1/10 --to 10 --route index

minkref events g1 g2 --kind arrangement --where 'kind = triple and s > 7/5 and change = swap'

minkref events g1 g2 --where 'x in [0, 5] and y > 1/3 and parents has S 0.4' -o - --format jsonl

minkref events g1 g2 --kind topology --where 'feature = hole and not change in (birth, death)'

minkref events g1 g2 --form printed --arithmetic mpfr:53

minkref events P.off Q.off --from 1/5 --to 2 -o events.jsonl

minkref events g1 disc --kind topology

minkref events g1 disc --kind pair --to 5"""

MEANINGS = {  # of the changes, under the table
    "pair": "birth, death: two edges of the convolution start, or cease, to meet as s grows. Where "
    "holes and components of the sum do, --kind topology says.",
    "parallel": "birth, death: two parallel edges start, or cease, to share a piece as s grows. "
    "Where holes and components of the sum do, --kind topology says.",
    "topology": "before, after: the features that take part, by number; `outside` is no hole.",
}
SHOWN = 10  # events that people see
LISTED = 1000  # of the paper's program, where no limit is given
PAIR_COUNTS = (
    "pairs", "filtered_pairs", "intersecting_pairs", "always_meeting_pairs", "touching_pairs",
    "parallel_pairs", "kernel", "by_float", "by_integer", "by_rational",
)  # fmt: skip
LIVES = 24  # holes and components whose lives people see


def command(
    P: FirstOperand,
    Q: SecondOperand,
    from_scale: WindowFrom = None,
    to_scale: WindowTo = None,
    kind: Annotated[
        str | None,
        typer.Option(
            "--kind",
            help="pair: two edges of the convolution start or stop meeting. "
            "parallel: two parallel edges lie on one line at that scale. "
            "triple: three edges pass through one point. "
            "arrangement: all three. "
            "In space these are of facets: pair of two, triple of three and of four. "
            "boundary: the vertices of the sum's boundary or their order change. "
            "topology: a hole or component is born, dies, merges, splits or touches itself. "
            "Default: pair; with --index, and with a disc, boundary.",
        ),
    ] = None,
    form: Annotated[
        str,
        typer.Option("--form", help="corrected, or printed: the paper's own rule, often wrong."),
    ] = "corrected",
    arithmetic: Annotated[
        str,
        typer.Option(
            "--arithmetic",
            help="rational (exact), interval, double or mpfr:BITS. With all but the first, and "
            "with --reading, the paper's program is followed: its events are listed with the exact "
            "scales beside them, and how its method fares is counted.",
        ),
    ] = "rational",
    reading: Annotated[
        list[str] | None,
        typer.Option(
            "--reading",
            help="Follow the paper's program, with one formula as read whatever --form says; may "
            f"be repeated. {PLANE_CHOICES.names()}.",
            metavar="NAME=VALUE",
        ),
    ] = None,
    least: Annotated[
        bool,
        typer.Option(
            "--least-precision",
            help="Also find the fewest bits of mpfr at which the paper's method gets every event "
            "right (slow).",
        ),
    ] = False,
    route: Annotated[
        str | None,
        typer.Option(
            "--route",
            help="How boundary and topology events are found: dynamic (the default), from all "
            "events of the arrangement, or index, from the boundary of the swept sum, which is "
            "faster for large operands.",
        ),
    ] = None,
    index: IndexFile = None,
    where: Annotated[
        str | None,
        typer.Option(
            "--where",
            help="List only the events that meet a condition: 's > 7/5 and change = birth', "
            "'1 < s <= 2', 'x in [0, 5] and y in (-1, 1)', 'parents has S 0.4 at 0.7', 'rank < 9'; "
            "of topology events also 'feature = hole', 'before has 3', 'parts > 1'. With `and`, "
            "`or`, `not`. Exact.",
            metavar="CONDITION",
        ),
    ] = None,
    limit: Annotated[
        int | None,
        typer.Option("--limit", help="List only the first N events; all are counted.", metavar="N"),
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option(
            "-o",
            help="Write the events to this file: .json, .jsonl (one event per line) or .parquet; "
            "- is standard output.",
            metavar="FILE",
        ),
    ] = None,
    file_format: Annotated[
        str | None,
        typer.Option(
            "--format", help=f"Format of the file: {', '.join(FORMATS)}. Default: by its ending."
        ),
    ] = None,
    memory: Memory = None,
    json: Json = False,
    schema: Schema = False,
) -> None:
    """All scales at which edges of the reduced convolution start or stop meeting: exact, sorted. In
    space, where P and Q are polyhedra, those at which two of its facets start, change or stop to
    meet in a window. With `disc` for Q, the radii at which the sum with a disc changes, or, of the
    kind pair, at which two offset edges or arcs start or stop to meet."""
    watch = Stopwatch()
    if is_disc(Q):
        from minkref.disc.commands.events import events_with_disc
        from minkref.disc.commands.pair_events import pair_events_with_disc

        given = {
            "--arithmetic": arithmetic != "rational", "--reading": bool(reading),
            "--least-precision": least, "--route": route not in (None, "index"),
            "--where": where is not None,
        }  # fmt: skip
        window_and_output = (from_scale, to_scale, limit, output, file_format, json, memory)
        if kind == "pair":
            given |= {"--index": index is not None, "--route": route is not None}
            pair_events_with_disc(P, Q, form, *window_and_output, given)
        else:
            if form not in FORMS:
                raise Refusal(f"there is no form {form!r}", "--form", choice(form, FORMS))
            if form != "corrected":
                what = "events of a disc of the kind pair alone have a printed form"
                raise Refusal(what, f"--form {form}", "add --kind pair, or leave it out")
            events_with_disc(P, Q, kind, *window_and_output, index, given)
        return
    kind = kind or ("pair" if index is None else "boundary")
    space = in_space(P, Q)
    if space:
        from minkref.space.commands.events import KINDS as SPACE_KINDS
        from minkref.space.commands.events import events_in_space, refuse_in_space
    if kind not in KINDS:
        mend = choice(kind, SPACE_KINDS if space else KINDS)
        raise Refusal(f"there is no kind {kind!r} of events", "--kind", mend)
    _check(kind, form, arithmetic, least, limit)
    if space:
        refuse_in_space(kind, form, arithmetic, reading, least, route, index, where)
        events_in_space(
            P,
            Q,
            kind,
            from_scale,
            to_scale,
            limit,
            output,
            file_format,
            json,
            memory,
            arithmetic,
            form,
        )
        return
    if reading and kind != "pair":
        what = "the paper's program has pair events only"
        raise Refusal(what, f"--kind {kind} --reading {reading[0]}", "leave out one of the two")
    as_read = arithmetic != "rational" or reading
    readings = readings_of(form, reading) if as_read else None
    condition = _condition(where, kind)
    target = target_of(output, file_format, FORMATS, "json", json)
    _check_parquet(target, kind)
    route = _route(kind, route, index)
    window = read_window(from_scale, to_scale)
    first, second = read_operand(P), read_operand(Q)
    if output is not None:
        refuse_overwriting(output, [first.file, second.file])
        refuse_overwriting_index(output, index)
    operands = f"{first.name} and {second.name}"
    with memory_wall(memory, f"{kind} events", operands, SMALLER):
        found: EventList
        if route == "index":
            swept = index_of(index, first, second, window[0], window[1])
            window = [own or bound for own, bound in zip(window, swept.window, strict=True)]
            found = BoundaryEventList(swept, kind, window)
        else:
            with progress(1) as line:
                line.now(f"finding all {kind} events")
                found = refusing(
                    operands, lambda: find_events(first.set, second.set, window, kind, form)
                )
        counts = _counts(found, first, second, window)
        trial: dict[str, Any] | None = None
        literal: dict[str, Any] | None = None
        if readings is not None:
            from minkref.verbs.paper_update import paper_walk

            walk = paper_walk(first, second, "1", arithmetic, readings)
            most = LISTED if limit is None else limit
            literal = {"readings": readings, **walk.events(most)}
        if arithmetic != "rational" or readings is not None:
            trial = dict(
                refusing(
                    operands, lambda: _core.precision_trial(first.set, second.set, arithmetic, form)
                )
            )
        counts.update(count=len(found), distinct=found.distinct)
        if condition is not None:
            found.keep(condition)
        counts.update(matching=len(found), matching_distinct=found.distinct)
        fields: dict[str, Any] = {
            "P": first.name,
            "Q": second.name,
            "from": window[0],
            "to": window[1],
            "kind": kind,
            "form": form,
            "arithmetic": arithmetic,
            "route": route,
            "where": where,
            "warnings": first.warnings + second.warnings,
            "output": str(output) if output else None,
            "compute_seconds": found.seconds,
            "segments": {"S": counts.pop("s_edges"), "T": counts.pop("t_edges")},
            "signs": {name: counts.pop(name) for name in ("by_float", "by_integer", "by_rational")},
            "kernel": counts.pop("kernel"),
            **counts,
            "trial": trial,
            "literal": literal,
            "least_precision": _least(first, second, form) if least else None,
            **found.features(),
        }
        count = len(found) if limit is None else min(limit, len(found))
        head = document("events", watch, **fields)
        if target is not None:
            write_events(target, head, found, count)
        if json and target is None:
            print_pieces(document_pieces(head, found, count))
        elif json:
            sys.stdout.write(as_text(document("events", watch, **fields, events=None)))
        elif target is None or not target.is_standard_output:
            shown_events = SHOWN if limit is None else limit
            _print(document("events", watch, **fields), found, shown_events)


def _condition(where: str | None, kind: str) -> _core.EventCondition | None:
    if where is None:
        return None
    from minkref.plane.event_filter import read_filter

    return read_filter(where, kind)


def _route(kind: str, route: str | None, index: Path | None) -> str | None:
    """The route of boundary and topology events; other kinds have none."""
    if kind in ROUTED_KINDS:
        return chosen_route(index, route, ROUTES)
    if route is not None or index is not None:
        raise Refusal(
            f"{kind} events come from the arrangement: there is only one route to them",
            "--route" if index is None else f"--index {index}",
            "leave it out, or choose --kind boundary or --kind topology",
        )
    return None


def _counts(found: EventList, P: Operand, Q: Operand, window: list[str | None]) -> dict[str, Any]:
    """Counts of pairs of edges; of an index it has no need of them: null."""
    if isinstance(found, PairEventList):
        return dict(found.found.counts())
    if isinstance(found, BoundaryEventList) and isinstance(found.found, _core.ScaleIndex):
        counted_edges = found.found.counts()
        edges = {name: counted_edges[name] for name in ("s_edges", "t_edges")}
        return {**dict.fromkeys(PAIR_COUNTS), **edges}
    pairs = refusing(
        f"{P.name} and {Q.name}", lambda: _core.pair_events(P.set, Q.set, window[0], window[1])
    )
    return dict(pairs.counts())


def _least(P: Operand, Q: Operand, form: str) -> dict[str, int | None]:
    from minkref.fuzz.least_precision import MOST_BITS, least_precision

    bits = refusing(f"{P.name} and {Q.name}", lambda: least_precision(P.set, Q.set, form))
    return {"bits": bits, "most_tried": MOST_BITS}


def _check(kind: str, form: str, arithmetic: str, least: bool, limit: int | None) -> None:
    if form not in FORMS:
        raise Refusal(f"there is no form {form!r}", "--form", choice(form, FORMS))
    check_arithmetic(arithmetic)
    if arithmetic != "rational" and kind != "pair":
        raise Refusal(
            "other arithmetics are tried on pair events",
            f"--kind {kind} --arithmetic {arithmetic}",
            "leave out one of the two options",
        )
    if least and kind != "pair":
        raise Refusal(
            "the least precision is found for pair events only",
            f"--kind {kind} --least-precision",
            "leave out one of the two options",
        )
    if form != "corrected" and kind not in PAIR_KINDS:
        raise Refusal(
            "the printed form has pair and parallel events only",
            f"--kind {kind} --form {form}",
            "leave out one of the two options",
        )
    if limit is not None and limit < 0:
        raise Refusal("the limit is negative", f"--limit {limit}", "give 0 or more")


def _check_parquet(target: Target | None, kind: str) -> None:
    if target is None or target.form != "parquet":
        return
    if kind not in PAIR_KINDS:
        raise Refusal(f"{kind} events are not written as Parquet", target.name, "name a .json file")
    if target.is_standard_output:
        raise Refusal("Parquet is written to a file", "-o -", "name one, or choose --format jsonl")


def _print(value: dict[str, Any], found: EventList, count: int) -> None:
    window = f"[{value['from'] or '0'}, {value['to'] or 'oo'}]"
    if value["from"] is None:
        window = "(" + window[1:]
    if value["to"] is None:
        window = window[:-1] + ")"
    segments, signs = value["segments"], value["signs"]
    total = sum(count or 0 for count in signs.values())
    rows = [
        (f"{value['kind']} events", f"{value['P']} + {value['Q']}, s in {window}"),
        ("form", value["form"]),
        ("edges", f"{segments['S']:,} S-edges, {segments['T']:,} T-edges"),
    ]
    if value["route"] is not None:
        rows += [("route", value["route"])]
    if value["pairs"] is not None:
        rows += [("pairs", f"{value['pairs']:,}; {value['filtered_pairs']:,} filtered by floats")]
    if value["kind"] == "pair":
        rows += [
            (
                "meeting",
                f"{value['intersecting_pairs']:,}, of them {value['always_meeting_pairs']:,} at "
                f"every scale; {value['touching_pairs']:,} more only touch",
            )
        ]
    elif value["kind"] == "parallel":
        rows += [("on one line", f"{value['parallel_pairs']:,}")]
    scales = counted(value["distinct"], "scale")
    rows += [("events", f"{value['count']:,} at {scales}")]
    if value["where"] is not None:
        scales = counted(value["matching_distinct"], "scale")
        rows += [("matching", f"{value['matching']:,} at {scales}: {value['where']}")]
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
        sys.stdout.write("\n" + lines(events_in_words(value["literal"])))
        print_literal(value["literal"]["rows"][:count])
    if value["output"] is None and value["trial"] is None:
        _print_first(found, count)
    for warning in value["warnings"]:
        sys.stderr.write(f"warning: {escaped(warning)}\n")


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


def _print_first(found: EventList, count: int) -> None:
    from rich.table import Table

    events = found.events(0, min(count, len(found)))
    if not events:
        return
    topology = events[0]["kind"] == "topology"
    table = Table("s", "about", "change", "before, after" if topology else "edges", "at")
    for event in events:
        where = ", ".join(rounded(x, 6) for x in event["at"])
        what = _features_text(event) if topology else _edges_text(event["parents"])
        change = f"{event['feature']}: {event['change']}" if topology else event["change"]
        table.add_row(event["s"], rounded(event["s"], 6), change, what, f"({where})")
    sys.stdout.write("\n")
    console().print(table)
    if len(found) > len(events):
        sys.stdout.write(f"{len(found) - len(events):,} more: --json or -o FILE gives all\n")
    if events[0]["kind"] in MEANINGS:
        sys.stdout.write(MEANINGS[events[0]["kind"]] + "\n")
    for name, lives in found.features().items():
        if lives:
            _print_lives(name, lives)


def _edges_text(edges: list[dict[str, Any]]) -> str:
    def place(at: list[int]) -> str:
        return f"{at[0]}.{at[1]}"

    texts = [f"{e['kind']} {place(e['edge'])} at {place(e['vertex'])}" for e in edges[:3]]
    return ", ".join([*texts, "..."] if len(edges) > 3 else texts)


def _features_text(event: dict[str, Any]) -> str:
    def names(features: list[int]) -> str:
        outside = event["feature"] == "hole"
        return ", ".join("outside" if outside and f == 0 else str(f) for f in features) or "-"

    return f"{names(event['before'])} to {names(event['after'])}"


def _print_lives(name: str, lives: list[dict[str, Any]]) -> None:
    """The scales between which each hole or component lives."""
    from rich.table import Table

    table = Table(name[:-1], "from", "to")
    for life in lives[:LIVES]:
        ends = [life["birth"], life["death"]]
        table.add_row(
            str(life["id"]),
            *(
                f"{which} of the window" if end is None else f"{end}, about {rounded(end, 6)}"
                for end, which in zip(ends, ("begin", "end"), strict=True)
            ),
        )
    sys.stdout.write("\n")
    console().print(table)
    if len(lives) > LIVES:
        sys.stdout.write(f"{len(lives) - LIVES:,} more {name}\n")
