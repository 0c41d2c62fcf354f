"""`minkref union`, `intersection` and `difference` of sets in the plane."""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

from minkref import _core, proved_program
from minkref.certify.plane.union_certificate import UnionCertificate
from minkref.cli.memory import SIMPLER, memory_wall
from minkref.cli.output import print_lines
from minkref.cli.plot_option import check_plot, print_plot
from minkref.errors import Refusal, refusing
from minkref.output.documents import (
    Stopwatch,
    as_text,
    document,
    refuse_overwriting,
    write_together,
)
from minkref.output.output_target import target_of
from minkref.output.terminal import escaped
from minkref.plane.commands.sum_fields import set_fields
from minkref.plane.commands.written_set import FORMS, written_set
from minkref.plane.operand import Operand, as_written
from minkref.plane.operand_text import STANDARD_INPUT
from minkref.plane.proved_sum import proved_combination
from minkref.verbs.certificate_output import CertificateFiles, Checked
from minkref.verbs.proof_option import proof_document, proof_files, proof_rows
from minkref.verbs.set_request import SetRequest, UnionRequest

Combine = Callable[[str, Sequence[_core.PolygonSet]], tuple[_core.PolygonSet, int, int]]
#: The theorem `verified_combination_is_sound`, and all that it does not speak about
#: (docs/proved.md).
PROVED = "where the program answers about sets, it gives that set, in canonical form"
TRUSTED = ("that the program was asked to do this, with these sets", proved_program.BELIEVED)
BETWEEN_POLYGONS = ("overlapping-rings", "crossing-rings", "overlapping-polygons")


def _run(operation: str, request: SetRequest) -> None:
    watch = Stopwatch()
    names = request.operands
    if names.count(STANDARD_INPUT) > 1:
        raise Refusal("standard input is one operand", "-", "name files for the others")
    if operation == "difference" and len(names) < 2:
        raise Refusal("there is one set only", names[0], "name the sets to take away from it")
    certify = request.certify if isinstance(request, UnionRequest) else None
    target = target_of(request.output, request.form, FORMS, "wkt", request.json)
    check_plot(request.plot, request.json, target)
    combine: Combine = _core.combined
    if request.proved:
        proved_program.program()
        combine = proved_combination
    with memory_wall(request.memory, f"the {operation}", " and ".join(names), SIMPLER):
        operands = [as_written(name) for name in names]
        if request.output is not None:
            refuse_overwriting(request.output, [operand.file for operand in operands])
        files = proof_files(certify, [operand.file for operand in operands], request.output)
        sets = [_whole(operand, combine) for operand in operands]
        began = time.perf_counter()
        found = refusing(", ".join(names), lambda: combine(operation, [one for one, _ in sets]))
        seconds = time.perf_counter() - began
        region, components, holes = found
        proof = None if files is None else _proved(files, names, [one for one, _ in sets], region)
    if proof is not None:
        write_together(dict(proof[0].contents()))
    is_exact = None
    if target is not None:
        text, is_exact = written_set(region, target)
        if target.write(text, is_exact):
            return
    value = document(
        operation,
        watch,
        operands=[
            {"name": operand.name, "polygons": len(operand.set.rings()), "united": united}
            for operand, (_, united) in zip(operands, sets, strict=True)
        ],
        warnings=[warning for operand in operands for warning in operand.warnings],
        output=None if request.output is None else str(request.output),
        output_exact=is_exact,
        compute_seconds=seconds,
        **set_fields(region, components, holes),
        result=json.loads(region.canonical_json()),
        proof={"proved": PROVED, "trusted": list(TRUSTED)} if request.proved else None,
        **({"certificate": proof_document(proof)} if operation == "union" else {}),
    )
    if request.json:
        sys.stdout.write(as_text(value))
        return
    _print(value)
    print_plot(request.plot, region)


def _proved(
    files: CertificateFiles,
    names: list[str],
    sets: list[_core.PolygonSet],
    region: _core.PolygonSet,
) -> tuple[Checked, UnionCertificate]:
    """The proof of the union and its degeneracies, checked and not written yet."""
    certificate = UnionCertificate(sets)
    certificate.union(region)
    certificate.degeneracies()
    return files.checked(certificate, escaped(", ".join(names)), True), certificate


def _whole(operand: Operand, combine: Combine) -> tuple[_core.PolygonSet, bool]:
    """The operand as a valid set, and whether its polygons had to be united. Refuses points and
    segments, and polygons that are invalid by themselves."""
    source = operand.source
    if not operand.set.is_region and operand.set.rings():
        mend = "leave it out, or give a polygon"
        raise Refusal("a point or a segment has no interior", source, mend, "no-interior")
    try:
        refusing(source, lambda: operand.set.validate(source))
        return operand.set, False
    except Refusal as error:
        if error.code not in BETWEEN_POLYGONS or len(operand.set.rings()) < 2:
            raise
    parts = []
    for number, rings in enumerate(operand.set.rings()):
        part = _core.PolygonSet([rings], validate=False)
        where = f"{source}, polygon {number}"
        refusing(where, partial(part.validate, where))
        parts.append(part)
    return combine("union", parts)[0], True


def _print(value: dict[str, Any]) -> None:
    rows = [
        ("of", ", ".join(_told(one) for one in value["operands"])),
        ("area", value["area"]),
        ("components", f"{value['components']:,}"),
        ("holes", f"{value['holes']:,}"),
        ("vertices", f"{value['vertices']:,}"),
        ("digest", value["digest"]),
    ]
    if value["output"]:
        rows.append(("written", value["output"]))
    rows += proof_rows(value)
    if value["proof"] is not None:
        rows.append(("proved", value["proof"]["proved"]))
        rows += [("trusted", each) for each in value["proof"]["trusted"]]
    rows.append(("seconds", f"{value['seconds']:.3f}"))
    print_lines(rows, value)


def _told(operand: dict[str, Any]) -> str:
    if not operand["united"]:
        return str(operand["name"])
    return f"{operand['name']} ({operand['polygons']:,} polygons, united first)"


run_union = partial(_run, "union")
run_intersection = partial(_run, "intersection")
run_difference = partial(_run, "difference")
