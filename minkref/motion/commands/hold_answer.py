"""The answer of `minkref hold` as a document and as text, in the plane and in space."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from minkref.cli.output import print_lines
from minkref.motion.commands.path_rows import (
    MOST_ROWS,
    extreme_scales,
    feature_text,
    number_text,
    point_text,
    range_documents,
    ranges_text,
)
from minkref.verbs.proof_option import certificate_text

MOTION = "translations only, along the way: another way or a rotation may do what it cannot"


def held_fields(rows: Any, told: Callable[[Any], dict[str, Any]]) -> dict[str, Any]:
    """The fields of the answer. `told`: the document of a contact."""
    fits, way, held = rows
    ranges = [row[0] for row in held]
    return {
        "held": [
            {**scales, "begin": _end(begin, told), "end": _end(end, told), "stop": told(stop)}
            for scales, (_, begin, end, stop) in zip(range_documents(ranges), held, strict=True)
        ],
        **extreme_scales(ranges),
        "fits": _scales(fits, told),
        "way": _scales(way, told),
    }


def _end(end: Any, told: Callable[[Any], dict[str, Any]]) -> dict[str, Any] | None:
    if end is None:
        return None
    at_place, contact = end
    return {"cause": "place" if at_place else "way", **told(contact)}


def _scales(rows: Any, told: Callable[[Any], dict[str, Any]]) -> dict[str, Any]:
    ranges, bounds, _ = rows
    return {"scales": range_documents(ranges), "bounds": [told(row) for row in bounds]}


def print_held(value: dict[str, Any]) -> None:
    star = "star-shaped about its origin" if value["star_shaped"] else "not star-shaped"
    rows = [
        ("part", f"{value['part']} in {value['obstacles']}, {star}"),
        ("way out", f"{value['path']}, vertices {value['vertices']:,}, contact {value['contact']}"),
        ("fits", f"at {point_text(value['at'])}: {ranges_text(value['fits']['scales'])}"),
        ("way valid", ranges_text(value["way"]["scales"])),
        ("held", ranges_text(value["held"])),
    ]
    in_space = "dimension" in value
    for one in value["held"][:MOST_ROWS]:
        rows += _range_rows(one, in_space)
    if len(value["held"]) > MOST_ROWS:
        rows.append(("more", f"{len(value['held']) - MOST_ROWS:,}; --json prints all"))
    rows.append(("motion", value["motion"]))
    if value["output"]:
        rows.append(("written", value["output"]))
    rows += [("certificate", certificate_text(one)) for one in value.get("certificates") or ()]
    rows.append(("seconds", f"{value['seconds']:.3f}"))
    print_lines(rows, value)


def _range_rows(one: dict[str, Any], in_space: bool) -> list[tuple[str, str]]:
    """Rows for a range's begin, stop and end."""
    rows = []
    for end, word in ((one["begin"], "begins"), (one["end"], "ends")):
        if end is not None:
            told = f"{word}, {_contact_text(end, in_space, end['cause'] == 'place')}"
            rows.append((number_text(end["scale"]), told))
    stop = one["stop"]
    rows.insert(
        len(rows) - (one["end"] is not None),
        (number_text(stop["scale"]), f"stops, {_contact_text(stop, in_space, False)}"),
    )
    return rows


def _contact_text(contact: dict[str, Any], in_space: bool, at_place: bool) -> str:
    part, obstacle = (feature_text(contact[one], in_space) for one in ("part", "obstacle"))
    at = contact["at"]
    where = (
        "at the place"
        if at_place
        else f"segment {at['segment']}, t = {number_text(at['t'])}, {point_text(at['point'])}"
    )
    return f"{where}: {part} of the part, {obstacle} of the obstacles"
