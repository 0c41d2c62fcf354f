"""Writes and prints the answer of `minkref path`, in the plane and in space."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from minkref.cli.output import give, print_lines
from minkref.motion.commands.path_rows import (
    MOST_ROWS,
    feature_text,
    number_text,
    point_text,
    ranges_text,
)
from minkref.output.documents import as_text, lasting, write_together
from minkref.output.output_target import Target
from minkref.verbs.certificate_output import Checked
from minkref.verbs.proof_option import proof_rows

FORMATS = ("json", "svg")  # of -o


def finish(
    value: dict[str, Any],
    target: Target | None,
    json: bool,
    drawn: Callable[[], str] | None = None,
    proofs: Sequence[Checked] = (),
    printed: Callable[[dict[str, Any]], None] | None = None,
) -> None:
    """Writes the proofs and the file of -o, or none of them. `drawn`: makes a picture; `printed`:
    prints the answer for a command besides `path`."""
    files: dict[Path, str | bytes] = {
        path: content for proof in proofs for path, content in proof.contents().items()
    }
    text = ""
    if target is not None:
        picture = drawn if target.form == "svg" else None
        text = as_text(lasting(value)) if picture is None else picture()
        if not target.is_standard_output:
            files[target.path] = text
    write_together(files)
    if target is not None and target.is_standard_output:
        target.write(text)
        return
    give(value, json, printed or _print)


def _print(value: dict[str, Any]) -> None:
    star = "star-shaped about its origin" if value["star_shaped"] else "not star-shaped"
    rows = [
        ("part", f"{value['part']}, {star}"),
        ("path", f"{value['path']}, vertices {value['vertices']:,}, contact {value['contact']}"),
        ("valid scales", ranges_text(value["valid"])),
    ]
    for bound in value["bounds"][:MOST_ROWS]:
        at = bound["at"]
        part, obstacle = (
            feature_text(bound[one], "dimension" in value) for one in ("part", "obstacle")
        )
        touching = f"{part} of the part, {obstacle}"
        place = f"segment {at['segment']}, t = {number_text(at['t'])}, {point_text(at['point'])}"
        rows.append(
            (number_text(bound["scale"]), f"{bound['event']}: {touching} of the obstacles; {place}")
        )
    if len(value["bounds"]) > MOST_ROWS:
        rows.append(("more", f"{len(value['bounds']) - MOST_ROWS:,}; --json prints all"))
    if value["output"]:
        rows.append(("written", value["output"]))
    rows += proof_rows(value)
    rows.append(("seconds", f"{value['seconds']:.3f}"))
    print_lines(rows, value)
