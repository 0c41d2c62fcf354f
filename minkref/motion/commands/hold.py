"""`minkref hold`: the scales at which obstacles hold a part, in the plane and in space."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.certify.motion.path_certificate import PathCertificate
from minkref.errors import refusing
from minkref.motion.commands.hold_answer import MOTION, held_fields, print_held
from minkref.motion.commands.path_answer import finish
from minkref.motion.commands.path_input import PathInput, input_in_plane, input_in_space
from minkref.motion.commands.path_proof import proved
from minkref.motion.commands.path_rows import contact_document, space_contact_document
from minkref.motion.path_text import ExactPoint
from minkref.motion.scale_ranges import range_values
from minkref.verbs.certificate_output import CertificateFiles, Checked
from minkref.verbs.hold import HoldInPlane, HoldInSpace
from minkref.verbs.proof_option import proof_document, proof_files

QUESTIONS = ("place", "way")  # each has a certificate


def run(request: HoldInPlane) -> None:
    asked = input_in_plane(request)
    proofs = [
        proof_files(name, asked.files, request.output) for name in _certificates(request.certify)
    ]
    points = asked.way.points
    with asked.memory_wall("the way"):
        rows = refusing(asked.where, lambda: asked.scales(_core.held_scales))
        proven = [
            _proved(proof, asked, places, found[0])
            for proof, places, found in zip(proofs, (points[:1], points), rows, strict=False)
        ]
    certificates = [proof_document(proof) for proof in proven] or None
    answer = {**_answer(asked, rows, contact_document), "certificates": certificates}
    finish(
        asked.document("hold", MOTION, answer),
        asked.target,
        request.json,
        lambda: _drawn(asked, rows),
        [proof[0] for proof in proven if proof is not None],
        print_held,
    )


def run_in_space(request: HoldInSpace) -> None:
    asked = input_in_space(request)
    with asked.memory_wall("the way"):
        rows = refusing(asked.where, lambda: asked.scales(_core.held_scales_in_space))
    value = asked.document("hold", MOTION, _answer(asked, rows, space_contact_document))
    finish(value, asked.target, request.json, printed=print_held)


def _answer(asked: PathInput, rows: Any, told: Callable[[Any], dict[str, Any]]) -> dict[str, Any]:
    return {"at": list(asked.way.points[0]), **held_fields(rows, told)}


def _certificates(certify: Path | None) -> list[Path]:
    """The names of the two certificates. Refuses an unusable name."""
    if certify is None:
        return []
    stem = CertificateFiles.of(certify, "--certify").case.name.removesuffix(".case.json")
    ending = certify.name.removeprefix(stem)
    return [certify.with_name(f"{stem}-{question}{ending}") for question in QUESTIONS]


def _proved(
    files: CertificateFiles | None, asked: PathInput, places: Sequence[ExactPoint], ranges: Any
) -> tuple[Checked, PathCertificate] | None:
    def claim(made: PathCertificate) -> int:
        return made.valid(asked.request.contact, *asked.window, range_values(ranges))

    return proved(files, asked.names, (asked.part, asked.obstacles), places, claim)


def _drawn(asked: PathInput, rows: Any) -> str:
    """The diagram of places and scales that collide on the way, with the held scales."""
    from minkref.motion.page.diagram_svg import diagram_svg
    from minkref.motion.page.picture import PathQuestion, held_picture, window_around

    fits, way, held = rows
    question = PathQuestion(asked.part, asked.obstacles, asked.way.points, asked.request.contact)
    shown = window_around([*fits[1], *way[1]], *asked.window)
    data = refusing(asked.where, lambda: held_picture(question, way, held, shown))
    return diagram_svg(data)
