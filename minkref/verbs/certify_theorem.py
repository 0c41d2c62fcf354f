"""`minkref certify --theorem FILE.v`: a sum, or a point, as a theorem of Coq (docs/proved.md)."""

from __future__ import annotations

import re
from pathlib import Path

from minkref import proved_program
from minkref.errors import Refusal
from minkref.output.documents import check_writable, scratch_folder
from minkref.verbs import check_proved
from minkref.verbs.certificate_output import Checked

NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*\.v", re.ASCII)
HOW = "coqc -Q build/proofs Proved"  # in the source tree, after make proofs


def check_theorem(path: Path, of_one_scale: bool) -> None:
    """Refuses, before any work is done, what cannot be written."""
    if not of_one_scale:
        mend = "give --scale or --point"
        raise Refusal("a theorem is about a sum, or a point", "--theorem", mend)
    if not NAME.fullmatch(path.name):
        mend = "name it FILE.v, of letters, digits and _"
        raise Refusal("this is not the name of a file of Coq", str(path), mend)
    proved_program.program("--theorem")
    check_writable(path)


def theorem_of(certificate: Checked) -> bytes:
    """States the sum or the point of a certificate, proved by computation. Raises RuntimeError
    where the proved checker refuses the certificate: a fault of minkref."""
    with scratch_folder() as folder:
        plain, part = folder / "it.cert.json", folder / "theorem.v"
        plain.write_bytes(certificate.text.encode())
        (folder / certificate.files.case.name).write_bytes(certificate.case.encode())
        name = certificate.files.output.name
        found = check_proved.follow(plain, f"--theorem={part}")
        if found.word != "verified":
            raise RuntimeError(f"no theorem of {name}: {found.word}: {found.why}")
        return part.read_bytes()
