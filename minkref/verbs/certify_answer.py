"""What `minkref certify` does in each setting: a proof made, checked, written, and told of."""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from minkref.cli.memory import SIMPLER, memory_wall
from minkref.errors import refusing
from minkref.output.documents import (
    Stopwatch,
    as_text,
    check_writable,
    document,
    refuse_overwriting,
    write_together,
)
from minkref.output.terminal import counted, escaped
from minkref.verbs.certificate_output import CHECKED, CertificateFiles, Claiming
from minkref.verbs.certify import CertifyInPlane, CertifyInSpace
from minkref.verbs.certify_theorem import HOW, theorem_of


@dataclass(frozen=True)
class Proof:
    """The files of the operands, and the maker of the certificate."""

    sources: list[Path]
    make: Callable[[], Claiming]


def certify(
    request: CertifyInPlane | CertifyInSpace,
    files: CertificateFiles,
    proof: Callable[[], Proof],
    theorem: Path | None = None,
) -> None:
    """`proof` reads the operands; `theorem`: where the sum is stated for Coq as well."""
    watch = Stopwatch()
    P, Q = request.P, request.Q
    with memory_wall(request.memory, "the proof", f"{P} and {Q}", SIMPLER):
        asked = proof()
        files.refuse(asked.sources)
        if theorem is not None:
            check_writable(theorem)
            refuse_overwriting(theorem, asked.sources)
        operands = f"{escaped(P)} and {escaped(Q)}"
        certificate = refusing(operands, asked.make)
        checked = files.checked(certificate, operands, request.check)
    written: dict[Path, str | bytes] = {**checked.contents()}
    if theorem is not None:
        written[theorem] = theorem_of(checked)
    write_together(written)
    output = str(request.output)
    value = document(
        "certify",
        watch,
        output=output,
        case=str(files.case),
        bytes=checked.size,
        claims=certificate.claims,
        verified=checked.verified,
        **({} if theorem is None else {"theorem": str(theorem)}),
    )
    if request.json:
        sys.stdout.write(as_text(value))
        return
    sys.stdout.write(
        f"{escaped(output)}: {counted(len(certificate.claims), 'claim')}, "
        f"{value['bytes']:,} bytes, {value['seconds']:.2f} s\n"
        f"its case: {escaped(str(files.case))}\n"
        f"{CHECKED[checked.verified]}\ncheck it: minkref check {escaped(output)}\n"
    )
    if theorem is not None:
        sys.stdout.write(f"the theorem: {HOW} {escaped(str(theorem))}\n")
