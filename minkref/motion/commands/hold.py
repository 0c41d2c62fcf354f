"""`minkref hold` in the plane: the scales at which an assembly holds a part."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.certify.motion.path_certificate import PathCertificate
from minkref.cli.memory import SMALLER, memory_wall
from minkref.errors import refusing
from minkref.exact import text_of_bounds
from minkref.motion.commands.hold_answer import MOTION, held_fields, print_held, way_fields
from minkref.motion.commands.path_answer import finish
from minkref.motion.commands.path_proof import proof_document, proof_files, proved
from minkref.motion.commands.path_rows import contact_document
from minkref.motion.path_text import ExactPoint, read_path
from minkref.motion.scale_ranges import CONTACTS, PATH_ROUTES, range_values
from minkref.output.documents import Stopwatch, document, refuse_overwriting
from minkref.output.output_target import target_of
from minkref.plane.operand import read_operand
from minkref.verbs.certificate_output import CertificateFiles, Checked
from minkref.verbs.hold import HoldInPlane
from minkref.verbs.path import check_words

FORMS = ("json", "svg")  # that -o writes
QUESTIONS = ("place", "way")  # each has a certificate


def run(request: HoldInPlane) -> None:
    watch = Stopwatch()
    output, contact, route = request.output, request.contact, request.route
    window = text_of_bounds(request.from_scale, request.to_scale)
    check_words(contact=(contact, CONTACTS), route=(route, PATH_ROUTES))
    target = target_of(output, None, FORMS, FORMS[0], request.json, has_format=False)
    first, second = read_operand(request.part), read_operand(request.obstacles)
    way = read_path(request.way)
    files = [first.file, second.file, *([way.file] if way.file else [])]
    if output is not None:
        refuse_overwriting(output, files)
    proofs = [proof_files(name, files, output) for name in _certificates(request.certify)]
    where = f"{request.part}, {request.obstacles}"
    sets, names = (first.set, second.set), (first.name, second.name)
    asked = (way.points[:1], way.points)
    with memory_wall(request.memory, "the way", f"{request.part} and {request.obstacles}", SMALLER):
        rows = refusing(
            where,
            lambda: _core.held_scales(*sets, way.points, contact, window[0], window[1], route),
        )
        proven = [
            _proved(proof, names, sets, places, contact, window, found[0])
            for proof, places, found in zip(proofs, asked, rows, strict=False)
        ]
    value = document(
        "hold",
        watch,
        part=first.name,
        obstacles=second.name,
        **way_fields(way.name, way.points),
        contact=contact,
        route=route,
        **{"from": window[0], "to": window[1]},
        motion=MOTION,
        **held_fields(rows, contact_document),
        star_shaped=_core.star_shaped(first.set),
        warnings=first.warnings + second.warnings,
        output=None if output is None else str(output),
        certificates=[proof_document(proof) for proof in proven] or None,
    )
    finish(
        value,
        target,
        request.json,
        lambda: _drawn(where, (*sets, way.points, contact), rows, window),
        [proof[0] for proof in proven if proof is not None],
        print_held,
    )


def _certificates(certify: Path | None) -> list[Path]:
    """The names of the two certificates. Refuses an unusable name."""
    if certify is None:
        return []
    stem = CertificateFiles.of(certify, "--certify").case.name.removesuffix(".case.json")
    ending = certify.name.removeprefix(stem)
    return [certify.with_name(f"{stem}-{question}{ending}") for question in QUESTIONS]


def _proved(
    files: CertificateFiles | None,
    names: tuple[str, str],
    sets: tuple[_core.PolygonSet, _core.PolygonSet],
    places: Sequence[ExactPoint],
    contact: str,
    window: Sequence[str | None],
    ranges: Any,
) -> tuple[Checked, PathCertificate] | None:
    def claim(made: PathCertificate) -> int:
        return made.valid(contact, window[0], window[1], range_values(ranges))

    return proved(files, names, sets, places, claim)


def _drawn(where: str, asked: tuple[Any, ...], rows: Any, window: Sequence[str | None]) -> str:
    """The diagram of places and scales that collide on the way, with the held scales."""
    from minkref.motion.page.diagram_svg import diagram_svg
    from minkref.motion.page.picture import PathQuestion, held_picture, window_around

    fits, way, held = rows
    shown = window_around([*fits[1], *way[1]], *window)
    data = refusing(where, lambda: held_picture(PathQuestion(*asked), way, held, shown))
    return diagram_svg(data)
