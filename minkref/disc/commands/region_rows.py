"""Regions and rest material in the document of `minkref features`, and for people."""

from __future__ import annotations

from typing import Any

from minkref.certain_digits import between
from minkref.disc.commands.sum import enclosed, term_rows
from minkref.disc.feature_regions import RegionsAt
from minkref.output.terminal import console, counted

Row = dict[str, Any]


def region_rows(found: RegionsAt) -> Row:
    return {
        "components": found.components,
        "holes": found.holes,
        "area": enclosed(found.shape_area),
        "of_features": [
            {
                "node": feature.node,
                "area": enclosed(feature.area),
                "terms": term_rows(feature.terms),
            }
            for feature in found.features
        ],
    }


def rest_rows(found: RegionsAt) -> Row:
    features, rest = found.features, found.rest
    return {
        "area": enclosed(found.rest_area),
        "of_features": [
            {"node": feature.node, "components": own.components, "area": enclosed(own.area)}
            for feature, own in zip(features, rest, strict=True)
        ],
    }


def print_regions(regions: Row | None, rest: Row | None) -> None:
    out = console()
    if regions is not None:
        count = counted(sum(row["area"]["high"] != 0 for row in regions["of_features"]), "region")
        parts = [counted(regions[f"{name}s"], name) for name in ("component", "hole")]
        told = ", ".join([*parts, count])
        out.print(f"alpha-shape  {told}, area {between(**regions['area'])}")
    if rest is not None:
        count = counted(sum(row["components"] for row in rest["of_features"]), "component")
        out.print(f"rest  {count}, area {between(**rest['area'])}")
