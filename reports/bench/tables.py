"""The tables of `minkref bench` for people."""

from __future__ import annotations

import sys
from typing import Any

from minkref.output.terminal import console, lines
from minkref.reports.bench.baselines import ABOUT, CGAL
from minkref.reports.bench.table1 import PAPER_MEAN
from minkref.reports.bench.table2 import ABOUT as KINDS
from rich.table import Table


def print_polygons(value: dict[str, Any], seed: int) -> None:
    out = console()
    out.print(_pairs_table(value["pairs"]))
    for measure, title in (
        ("intersections", "Updating all intersections, against finding them afresh"),
        ("sum", "Updating and giving the sum, against computing the sum afresh"),
    ):
        rows = [row for row in value["rows"] if row["measure"] == measure]
        out.print()
        out.print(_rows_table(title, rows))
    text = [("re-scalings", f"{value['rescalings']} out of 0.1, 0.2, ..., 10; seed {seed}")]
    for name, mean in value["mean_ratios"].items():
        reached = f"{mean:.2f}" if mean is not None else "not all pairs were timed"
        text.append((f"mean ratio, {name}", f"{reached} over the small pairs: {ABOUT[name]}"))
    for name, mean in value["means_of_ratios"].items():
        if mean is not None:
            text.append((f"mean of ratios, {name}", f"{mean:.2f}: of single re-scalings"))
    text.append(
        ("the paper's", f"{PAPER_MEAN} over 25 pairs of its own polygons, by all pairs of edges in "
         "MPFR on another machine: not to be compared pair by pair")
    )  # fmt: skip
    text += [("note", note) for note in value["notes"]]
    text += [("WRONG", f"the sum differs from the static one: {wrong}") for wrong in value["wrong"]]
    sys.stdout.write("\n" + lines(text))


def _pairs_table(rows: list[dict[str, Any]]) -> Table:
    table = Table(box=None, pad_edge=False, title="Pairs", title_justify="left")
    headings = ("pair", "edges", "events", "scales crossed", "changes", "update ms", "all events s")
    for heading in headings:
        table.add_column(heading, justify="left" if heading == "pair" else "right", no_wrap=True)
    for row in rows:
        table.add_row(
            row["name"],
            f"{row['edges']:,}",
            f"{row['events']:,}",
            f"{row['event_scales_per_step']:,.0f}",
            f"{row['changes_per_step']:,.0f}",
            milliseconds(row["update"]["median"]),
            f"{row['preprocessing_seconds']:.3f}",
        )
    return table


def _rows_table(title: str, rows: list[dict[str, Any]]) -> Table:
    table = Table(box=None, pad_edge=False, title=title, title_justify="left")
    headings = ("pair", "against", "timed", "ours ms", "theirs ms", "ratio", "mean", "median",
                "quartiles", "pays from")  # fmt: skip
    for heading in headings:
        left = heading in ("pair", "against")
        table.add_column(heading, justify="left" if left else "right", no_wrap=True)
    for row in rows:
        of_each = row["ratios"]
        table.add_row(
            row["name"],
            row["baseline"],
            f"{row['rescalings_timed']} of {row['rescalings']}",
            milliseconds(row["ours_s"]),
            milliseconds(row["baseline_s"]),
            f"{row['ratio']:,.2f}",
            f"{of_each['mean']:,.2f}",
            f"{of_each['median']:,.2f}",
            f"{of_each['lower']:,.1f} - {of_each['upper']:,.1f}",
            f"{row['break_even']:,}" if row["break_even"] is not None else "never",
        )
    return table


def milliseconds(seconds: float) -> str:
    return f"{seconds * 1000:,.4f}" if seconds < 0.01 else f"{seconds * 1000:,.1f}"


def print_index(value: dict[str, Any], seed: int) -> None:
    out = console()
    out.print()
    out.print(_index_table(value["rows"]))
    out.print()
    out.print(_lazy_table(value["rows"]))
    for form in ("double", "homogeneous", "rational", "track"):
        out.print()
        out.print(_queries_table(f"Queries: {form}", value["rows"], form))
    text = [
        ("queries", f"at {value['queries']} scales from 1/10 to 10, one core; seed {seed}"),
        ("against", f"{CGAL}: {ABOUT[CGAL]}"),
    ]
    for form, mean in value["mean_ratios"].items():
        reached = f"{mean:,.0f}" if mean is not None else "not all pairs were timed"
        text.append((f"mean ratio, {form}", f"{reached} over the 25 small pairs"))
    text += [("note", note) for note in value["notes"]]
    text += [("WRONG", f"the sum differs from the static one: {wrong}") for wrong in value["wrong"]]
    sys.stdout.write("\n" + lines(text))


def _index_table(rows: list[dict[str, Any]]) -> Table:
    table = Table(box=None, pad_edge=False, title="The index", title_justify="left")
    headings = ("pair", "edges", "events", "vertices", "MB", "build s", "CGAL ms",
                "build in CGAL sums", "area us")  # fmt: skip
    for heading in headings:
        table.add_column(heading, justify="left" if heading == "pair" else "right", no_wrap=True)
    for row in rows:
        cgal, calls = row["cgal"], row["build_in_cgal_calls"]
        table.add_row(
            row["name"],
            f"{row['edges']:,}",
            f"{row['boundary_events']:,}",
            f"{row['vertices']:,.0f}",
            f"{row['bytes'] / 1e6:.2f}",
            f"{row['build_seconds']:.3f}",
            "-" if cgal is None else milliseconds(cgal["mean"]),
            "-" if calls is None else f"{calls:,.1f}",
            f"{row['forms']['area']['query']['mean'] * 1e6:.2f}",
        )
    return table


def _lazy_table(rows: list[dict[str, Any]]) -> Table:
    title = "The index, built when single sums have cost as much"
    table = Table(box=None, pad_edge=False, title=title, title_justify="left")
    headings = ("pair", "first ms", "in CGAL sums", "single sums", "all in builds", "pays from")
    for heading in headings:
        table.add_column(heading, justify="left" if heading == "pair" else "right", no_wrap=True)
    for row in rows:
        lazy, cgal = row["lazy"], row["cgal"]
        table.add_row(
            row["name"],
            milliseconds(lazy["first_seconds"]),
            "-" if cgal is None else f"{lazy['first_seconds'] / cgal['mean']:.2f}",
            f"{lazy['single_sums']:,}",
            f"{lazy['seconds_when_built'] / row['build_seconds']:.2f}",
            "-" if lazy["pays_from"] is None else f"{lazy['pays_from']:,}",
        )
    return table


def _queries_table(title: str, rows: list[dict[str, Any]], form: str) -> Table:
    table = Table(box=None, pad_edge=False, title=title, title_justify="left")
    for heading in ("pair", "us", "quartiles", "/floor", "CGAL/", "pays from"):
        table.add_column(heading, justify="left" if heading == "pair" else "right", no_wrap=True)
    for row in rows:
        own = row["forms"][form]
        query, floor, ratio = own["query"], own["floor_ratio"], own["cgal_ratio"]
        table.add_row(
            row["name"],
            f"{query['mean'] * 1e6:,.2f}",
            f"{query['lower'] * 1e6:,.2f} - {query['upper'] * 1e6:,.2f}",
            "-" if floor is None else f"{floor:.2f}",
            "-" if ratio is None else f"{ratio:,.0f}",
            "-" if own["break_even"] is None else f"{own['break_even']:,}",
        )
    return table


def print_polyhedra(value: dict[str, Any], seed: int) -> None:
    out = console()
    for kind, about in KINDS.items():
        rows = [row for row in value["rows"] if row["kind"] == kind]
        out.print()
        out.print(_polyhedra_table(f"Convex polyhedra, {about}", rows))
    text = [("re-scalings", f"{value['rescalings']} of each pair and kind; seed {seed}")]
    for kind in KINDS:
        for name, what in (
            ("cgal_hull_ratio", "CGAL's hull over ours"),
            ("cgal_hull_surface_ratio", "CGAL's hull over ours with the surface"),
            ("brute_force_ratio", "all pairs over ours"),
            ("traversal_ratio", "best static route over ours"),
            ("floor_ratio", "ours over coordinates alone"),
        ):
            told = value[f"{kind}_{name}"]
            reached = (
                f"{told['least']:,.2f} to {told['greatest']:,.2f}, mean {told['mean']:,.2f}"
                if told
                else "not timed"
            )
            text.append((f"{kind}: {what}", reached))
    paper = value["paper"]
    text.append(
        ("the paper's", f"{paper['least']} to {paper['greatest']}, arithmetic mean "
         f"{paper['mean']}, of its own models, against its own recomputation, at factors whose "
         "range it does not give, on another machine: not to be compared pair by pair")
    )  # fmt: skip
    text += [("note", note) for note in value["notes"]]
    text += [("WRONG", wrong) for wrong in value["wrong"]]
    sys.stdout.write("\n" + lines(text))


def _polyhedra_table(title: str, rows: list[dict[str, Any]]) -> Table:
    table = Table(box=None, pad_edge=False, title=title, title_justify="left")
    headings = ("P", "Q", "pairs", "fv", "vf", "ee", "signs/error", "update µs", "with coord. µs",
                "with surface µs", "/floor", "static/", "all pairs/", "CGAL/",
                "CGAL/surface")  # fmt: skip
    for heading in headings:
        table.add_column(heading, justify="left" if heading in "PQ" else "right", no_wrap=True)
    for row in rows:
        table.add_row(
            row["P"],
            row["Q"],
            f"{row['vertex_pairs_mean']:,.0f}",
            *(f"{row[name]:,.1f}" for name in ("fv_errors", "vf_errors", "ee_errors")),
            _or_none(row["signs_per_error"], ".1f"),
            f"{row['update']['median'] * 1e6:,.1f}",
            f"{row['ours']['median'] * 1e6:,.1f}",
            f"{row['with_surface']['median'] * 1e6:,.0f}",
            f"{row['floor_ratio']:.2f}",
            f"{row['traversal_ratio']:,.2f}",
            _or_none(row["brute_force_ratio"], ",.0f"),
            _or_none(row["cgal_hull_ratio"], ",.0f"),
            _or_none(row["cgal_hull_surface_ratio"], ",.0f"),
        )
    return table


def _or_none(value: float | None, form: str) -> str:
    return "-" if value is None else format(value, form)
