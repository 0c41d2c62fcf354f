"""`minkref features P`: the merge tree, the barcode, and the bridges at one alpha."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.certain_digits import between
from minkref.cli.memory import SIMPLER, memory_wall
from minkref.cli.output import give, plain_table, written_row
from minkref.disc.commands.bridge_proof import proved_bridges
from minkref.disc.commands.events import feature_row
from minkref.disc.commands.index_file import from_places
from minkref.disc.commands.region_rows import print_regions, region_rows, rest_rows
from minkref.disc.commands.sum import enclosed
from minkref.disc.feature_regions import RegionsAt
from minkref.disc.features import FeatureBar, Features, LiveFeature
from minkref.errors import Refusal
from minkref.output.documents import (
    Stopwatch,
    as_text,
    document,
    lasting,
    refuse_overwriting,
    write_together,
)
from minkref.output.output_target import Target, target_of
from minkref.output.terminal import console, counted
from minkref.plane.commands.scale_index import cores, refuse_overwriting_index
from minkref.plane.operand import Operand, read_operand
from minkref.verbs.certificate_output import CertificateFiles
from minkref.verbs.features import FeaturesRequest
from minkref.verbs.proof_option import OPTION, proof_document, proof_files, proof_rows

FORMATS = ("json", "svg", "dxf")
SHOWN = 20  # bars that people see
Row = dict[str, Any]


def run(request: FeaturesRequest) -> None:
    watch = Stopwatch()
    output, alpha = request.output, request.alpha
    offered = FORMATS if alpha is not None else FORMATS[:2]
    target = target_of(output, request.form, FORMATS, "json", request.json, offered=offered)
    _check(request, target)
    proven = None
    with memory_wall(request.memory, "features", request.P, SIMPLER):
        operand = read_operand(request.P)
        if output is not None:
            refuse_overwriting(output, [operand.file])
            refuse_overwriting_index(output, request.index)
        files = proof_files(request.certify, [operand.file], output)
        built = from_places(
            request.index, operand, lambda places: _core.features(operand.set, cores(), places)
        )
        found = Features.of_core(built)
        alive = None if alpha is None else found.at(alpha)
        asked = request.regions or request.rest
        regions = found.regions(alpha) if asked else None
        if files is not None and alpha is not None:
            proven = proved_bridges(files, operand, alpha / 2, built)
        numbers = [k for k, bar in enumerate(found.bars) if _is_within(bar, request)]
        value = document(
            "features",
            watch,
            P=operand.name,
            warnings=[*operand.warnings, *(proven.warnings if proven else [])],
            output=str(output) if output else None,
            alpha=None if alpha is None else str(alpha),
            **{"from": _text(request.from_alpha)},
            to=_text(request.to_alpha),
            compute_seconds=built.seconds,
            exact_signs=built.exact_signs,
            digest=found.digest,
            **rows_of(found, numbers, alive),
            regions=region_rows(regions) if regions and request.regions else None,
            rest=rest_rows(regions) if regions and request.rest else None,
            certificate=proof_document(proven.proof if proven else None),
        )
        if proven is not None:
            write_together({**proven.proof[0].contents()})
        if target is not None:
            text = _written(target, value, found, operand, alive, regions)
            if target.write(text, target.form == "json"):
                return
    give(value, request.json, lambda value: _print(value, found, numbers))


def _check(request: FeaturesRequest, target: Target | None) -> None:
    first, last = request.from_alpha, request.to_alpha
    if first is not None and last is not None and first > last:
        mend = "give the smaller one to --from"
        raise Refusal("the window is empty", f"--from {first} --to {last}", mend, "empty-window")
    if target is not None and target.form == "dxf" and request.alpha is None:
        raise Refusal("bridges are of one alpha", target.name, "add --alpha A")
    for name, is_asked in (("--regions", request.regions), ("--rest", request.rest)):
        if is_asked and request.alpha is None:
            raise Refusal("regions and rest are of one alpha", name, "add --alpha A")
    if request.certify is not None and request.alpha is None:
        CertificateFiles.of(request.certify, OPTION)
        raise Refusal("bridges are of one alpha", OPTION, "add --alpha A")


def _text(bound: Fraction | None) -> str | None:
    return None if bound is None else str(bound)


def _is_within(bar: FeatureBar, request: FeaturesRequest) -> bool:
    """The bar has a part in the window; a bound between a bar's doubles counts as inside."""
    first, last = request.from_alpha, request.to_alpha
    return (first is None or math.isinf(bar.death[1]) or bar.death[1] >= first) and (
        last is None or bar.birth[0] <= last
    )


def rows_of(found: Features, numbers: list[int], alive: list[LiveFeature] | None) -> Row:
    """The fields of the document."""
    return {
        "tree": [
            {
                "kind": node.kind,
                "alpha": _last(node.alpha),
                "squared_radius": None if node.squared_radius is None else str(node.squared_radius),
                "polynomial": [str(c) for c in node.polynomial] or None,
                "parent": node.parent,
                "children": list(node.children),
                "places": [[_event(event) for event in group] for group in node.places],
                "vertex": None if node.vertex is None else [str(x) for x in node.vertex],
                "along": None if node.along is None else [str(x) for x in node.along],
                "tie": node.tie,
            }
            for node in found.tree
        ],
        "bars": [_bar(found.bars[k]) for k in numbers],
        "tracks": [
            {
                "birth": enclosed(track.birth),
                "death": _last(track.death),
                "from": _end(*track.ends[0]),
                "to": _end(*track.ends[1]),
                "features": [[feature_row(*a), feature_row(*b)] for a, b in track.features],
            }
            for track in found.tracks
        ],
        "features": None if alive is None else [_feature(each) for each in alive],
    }


def _last(bounds: tuple[float, float]) -> Row | None:
    return None if math.isinf(bounds[0]) else enclosed(bounds)


def _bar(bar: FeatureBar) -> Row:
    return {
        "leaf": bar.leaf,
        "birth": enclosed(bar.birth),
        "death": _last(bar.death),
        "end": bar.end,
        "persistence": _last(bar.persistence),
        "essential": bar.essential,
        "tie": bar.tie,
    }


def _event(event: Any) -> Row:
    square = event.squared_radius
    return {
        "kind": event.kind,
        "radius": enclosed(event.radius),
        "squared_radius": None if square is None else str(square),
        "polynomial": [str(c) for c in event.polynomial],
        "place": [c if math.isfinite(c) else None for c in event.place],
        "features": [feature_row(*feature) for feature in event.features],
    }


def _end(kind: str, told: tuple[str, ...]) -> Row:
    if kind == "event":
        return {"event": int(told[0])}
    points = [list(told[k : k + 2]) for k in range(0, len(told), 2)]
    return {kind: points[0] if kind == "vertex" else points}


def _feature(alive: LiveFeature) -> Row:
    return {
        "node": alive.node,
        "bar": alive.bar,
        "leaves": list(alive.leaves),
        "deepest": alive.deepest,
        "squared_depth": alive.squared_depth,
        "depth": None if alive.depth is None else _last(alive.depth),
        "tie": alive.tie,
        "bridges": [
            {
                "ends": [list(end) for end in bridge.ends],
                "near": [list(end) for end in bridge.near],
                "centre": list(bridge.centre),
                "features": [feature_row(*feature) for feature in bridge.features],
            }
            for bridge in alive.bridges
        ],
    }


def _written(
    target: Target,
    value: Row,
    found: Features,
    operand: Operand,
    alive: list[LiveFeature] | None,
    regions: RegionsAt | None,
) -> str:
    if target.form == "json":
        return as_text(lasting(value))
    bridges = [bridge.near for feature in alive or [] for bridge in feature.bridges]
    if target.form == "dxf":
        from minkref.output.dxf import dxf_of_lines

        return dxf_of_lines(bridges, "BRIDGES", target.name)
    from minkref.reports.features_picture import features_picture
    from minkref.reports.region_layers import DrawnRegions

    drawn = None
    if regions is not None:
        drawn = DrawnRegions(regions, value["regions"] is not None, value["rest"] is not None)
    return features_picture(operand.set, found, alive, operand.name, drawn)


def _print(value: Row, found: Features, numbers: list[int]) -> None:
    out = console()
    at = "" if value["alpha"] is None else f", {counted(len(value['features']), 'feature')} at "
    alpha = "" if value["alpha"] is None else f"alpha {value['alpha']}"
    out.print(f"{value['P']}: {counted(len(numbers), 'bar')}{at}{alpha}", markup=False)
    longest = sorted(
        numbers, key=lambda k: (found.bars[k].persistence[0], -k), reverse=True
    )[:SHOWN]  # fmt: skip
    if value["features"] is not None:
        _print_features(value["features"])
    elif longest:
        table = plain_table("persistence", "birth", "death", "of", "place", right=("persistence",))
        for k in longest:
            bar = found.bars[k]
            leaf = found.tree[bar.leaf]
            table.add_row(
                _told(bar.persistence), _told(bar.birth), _told(bar.death),
                leaf.kind + (" (tie)" if bar.tie else ""), _place(leaf),
            )  # fmt: skip
        out.print(table)
        if len(longest) < len(numbers):
            out.print(f"and {len(numbers) - len(longest):,} shorter ones (--json has them)")
    print_regions(value["regions"], value["rest"])
    rows = [*proof_rows(value), *written_row({**value, "output_exact": True})]
    for name, text in [("digest", value["digest"]), *rows]:
        out.print(f"{name}  {text}")


def _print_features(rows: list[Row]) -> None:
    table = plain_table("feature", "bridges", "deepest", "depth", right=("feature", "bridges"))
    for row in rows[:SHOWN]:
        depth = row["depth"]
        told = "none" if row["deepest"] is None else "infinite"
        deepest = "" if row["deepest"] is None else f"node {row['deepest']}"
        table.add_row(
            str(row["node"]), str(len(row["bridges"])), deepest,
            told if depth is None else between(**depth),
        )  # fmt: skip
    console().print(table)


def _told(bounds: tuple[float, float]) -> str:
    return "infinite" if math.isinf(bounds[0]) else between(*bounds)


def _place(leaf: Any) -> str:
    if leaf.vertex is not None:
        return f"{leaf.vertex[0]}, {leaf.vertex[1]}"
    x, y = leaf.places[0][0].place
    return f"about {x:.6g}, {y:.6g}"
