"""`minkref certify P Q -o FILE`: a proof of what minkref says, for those who do not trust it."""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Annotated

import typer
from minkref import _core
from minkref.certify.plane.certificate import Certificate, NoProof
from minkref.certify.space.convex_certificate import ConvexCertificate
from minkref.certify.space.solid_certificate import SolidCertificate
from minkref.cli.memory import SIMPLER, Memory, memory_wall
from minkref.cli.options import FirstOperand, Json, Schema, SecondOperand
from minkref.errors import Refusal, refusing
from minkref.exact import read_point, read_scale
from minkref.output.documents import (
    Stopwatch,
    as_text,
    check_writable,
    document,
    refuse_overwriting,
    write_together,
)
from minkref.output.terminal import counted, escaped
from minkref.plane.operand import read_operand
from minkref.space.operand import SpaceOperand, in_space, read_summand
from minkref.space.scaling import Scaling, read_scaling
from minkref.verbs.certificate_output import CHECKED, CertificateFiles
from minkref.verbs.certify_theorem import HOW, check_theorem, theorem_of

EXAMPLES = """Examples:

minkref certify disc1 cells1815 -o sum.cert.json

minkref certify P.wkt Q.wkt --event 541/186 -o event.cert.json

minkref certify P.wkt Q.wkt --degeneracy 541/186 -o zero.cert.json

minkref certify P.wkt Q.wkt --scale 2 --point 1/3,5 -o point.cert.json

minkref certify g1 g2 --from 1 --to 11/10 -o interval.cert.json.gz

minkref certify g1 g2 --scale 7/5 -o sum.cert.json --theorem sum.v

minkref certify gs3 rod --scale 2,1/3,5 -o convex.cert.json

minkref certify P.off Q.stl --scale 7/5 -o solids.cert.json"""


Make = Callable[[], Certificate | ConvexCertificate | SolidCertificate]


def command(
    P: FirstOperand,
    Q: SecondOperand,
    output: Annotated[
        Path,
        typer.Option(
            "-o", help="FILE.cert.json or FILE.cert.json.gz; the case is written next to it."
        ),
    ],
    scale: Annotated[
        str | None,
        typer.Option(
            "--scale",
            metavar="S",
            help="Prove the sum and its tight passages at S. Default: 1. In space also SX,SY,SZ.",
        ),
    ] = None,
    event: Annotated[
        str | None,
        typer.Option(
            "--event",
            metavar="S",
            help="Prove the topology event at S, or else the boundary event: the sum below, at "
            "and above S, and that there is no event between --from (default: the event before, "
            "or half of S) and S.",
        ),
    ] = None,
    from_scale: Annotated[
        str | None,
        typer.Option(
            "--from", metavar="A", help="Prove that there is no event between A and --to."
        ),
    ] = None,
    to_scale: Annotated[str | None, typer.Option("--to", metavar="B", help="See --from.")] = None,
    degeneracy: Annotated[
        str | None,
        typer.Option(
            "--degeneracy",
            metavar="S",
            help="Prove what makes S critical: which edges of the convolution meet there, as "
            "predicates that are zero at S, and their signs below and above.",
        ),
    ] = None,
    point: Annotated[
        str | None,
        typer.Option(
            "--point", metavar="X,Y", help="Prove only that this point is in the sum at --scale."
        ),
    ] = None,
    check: Annotated[
        bool,
        typer.Option(
            "--check/--no-check",
            help="Check the certificate before it is written, as `minkref check` does. Takes "
            "about as long as making it.",
        ),
    ] = True,
    theorem: Annotated[
        Path | None,
        typer.Option(
            "--theorem",
            metavar="FILE.v",
            help="Write the sum at --scale as a theorem of Coq too, proved by computation "
            "(docs/proved.md; `make proofs` builds what it takes).",
        ),
    ] = None,
    memory: Memory = None,
    json: Json = False,
    schema: Schema = False,
) -> None:
    """Write a certificate: a proof in steps that `minkref check`, or your own checker, verifies
    without trusting minkref (docs/certificates.md; for convex polyhedra
    docs/certificates-convex.md, for others docs/certificates-solids.md). It is checked before it is
    written; a certificate that is not a proof would be a fault of minkref, and is not written."""
    watch = Stopwatch()
    files = CertificateFiles.of(output, "-o")
    wish = Wish(scale, event, from_scale, to_scale, degeneracy, point)
    wish.check()
    if theorem is not None:
        check_theorem(theorem, not in_space(P, Q), wish.is_sum())
    with memory_wall(memory, "the proof", f"{P} and {Q}", SIMPLER):
        sources, make = (_in_space if in_space(P, Q) else _in_the_plane)(P, Q, wish)
        files.refuse(sources)
        if theorem is not None:
            check_writable(theorem)
            refuse_overwriting(theorem, sources)
        operands = f"{escaped(P)} and {escaped(Q)}"
        certificate = refusing(operands, make)
        checked = files.checked(certificate, operands, check)
    written: dict[Path, str | bytes] = {**checked.contents()}
    if theorem is not None:
        written[theorem] = theorem_of(checked)
    write_together(written)
    value = document(
        "certify",
        watch,
        output=str(output),
        case=str(files.case),
        bytes=checked.size,
        claims=certificate.claims,
        verified=checked.verified,
        **({} if theorem is None else {"theorem": str(theorem)}),
    )
    if json:
        sys.stdout.write(as_text(value))
    else:
        sys.stdout.write(
            f"{escaped(str(output))}: {counted(len(certificate.claims), 'claim')}, "
            f"{value['bytes']:,} bytes, {value['seconds']:.2f} s\n"
            f"its case: {escaped(str(files.case))}\n"
            f"{CHECKED[checked.verified]}\ncheck it: minkref check {escaped(str(output))}\n"
        )
        if theorem is not None:
            sys.stdout.write(f"the theorem: {HOW} {escaped(str(theorem))}\n")


def _in_the_plane(P: str, Q: str, wish: Wish) -> tuple[list[Path], Make]:
    """The files of the operands, and what makes the certificate."""
    first, second = read_operand(P), read_operand(Q)

    def make() -> Certificate:
        certificate = Certificate(first.set, second.set)
        try:
            wish.claim(certificate)
        except NoProof as error:
            mend = "`minkref events P Q --kind boundary` (or arrangement) lists the events"
            if wish.point is not None:
                mend = "`minkref sum P Q --scale S -o sum.svg` draws the sum"
            where = f"{first.name} and {second.name}"
            raise Refusal(str(error), where, mend, "no-proof") from error
        return certificate

    return [first.file, second.file], make


def _in_space(P: str, Q: str, wish: Wish) -> tuple[list[Path], Make]:
    """The same for polyhedra: convex ones have a form of their own."""
    scaling = wish.scaling()
    first, second = read_summand(P), read_summand(Q)
    for operand in (first, second):
        _refuse_thin(operand)

    def make() -> ConvexCertificate | SolidCertificate:
        convex = first.body is not None and second.body is not None
        form = ConvexCertificate if convex else SolidCertificate
        certificate = form(first.surface, second.surface)
        certificate.sum(scaling)
        return certificate

    return [first.file, second.file], make


def _refuse_thin(operand: SpaceOperand) -> None:
    """Refuses an operand without volume, which has no certificate."""
    if not operand.is_solid:
        mend = "give a polyhedron by its faces"
        raise Refusal("the operand has no volume", operand.name, mend, "not-solid")


@dataclass(frozen=True)
class Wish:
    """The statement to be certified, as the options give it."""

    scale: str | None
    event: str | None
    from_scale: str | None
    to_scale: str | None
    degeneracy: str | None
    point: str | None

    def check(self) -> None:
        """Refuses options that do not go together."""
        ends = self.from_scale is not None, self.to_scale is not None
        if any(ends) and not all(ends) and self.event is None and self.degeneracy is None:
            raise Refusal("an interval has two ends", "options", "give both --from and --to")
        chosen = [self.event is not None, self.degeneracy is not None, self.to_scale is not None]
        alone = sum(chosen) + (self.scale is not None or self.point is not None) <= 1
        if not alone or (self.from_scale is not None and not (chosen[0] or chosen[2])):
            mend = "choose --scale S [--point X,Y], --event S [--from A], --from A --to B, or "
            raise Refusal("these options do not go together", "options", mend + "--degeneracy S")

    def is_sum(self) -> bool:
        others = self.event, self.from_scale, self.to_scale, self.degeneracy, self.point
        return all(option is None for option in others)

    def claim(self, certificate: Certificate) -> None:
        if self.event is not None:
            s = read_scale(self.event, "--event")
            a = (
                read_scale(self.from_scale, "--from")
                if self.from_scale is not None
                else _before(certificate, s)
            )
            if Fraction(a) >= Fraction(s):
                raise Refusal("this is not below the event", "--from", "give a smaller scale")
            certificate.event(s, a)
        elif self.to_scale is not None:
            a, b = read_scale(self.from_scale or "", "--from"), read_scale(self.to_scale, "--to")
            if Fraction(a) >= Fraction(b):
                raise Refusal("the interval is empty", "--to", "give a larger scale than --from")
            certificate.interval(a, b)
        elif self.degeneracy is not None:
            certificate.degeneracy(read_scale(self.degeneracy, "--degeneracy"))
        elif self.point is not None:
            certificate.point(self._scale(), read_point(self.point))
        else:
            certificate.sum(self._scale(), passages=True)

    def scaling(self) -> Scaling:
        """In space, where there are certificates of sums only."""
        if not self.is_sum():
            what = "in space there are certificates of sums only"
            raise Refusal(what, "options", "give --scale SX,SY,SZ and -o alone")
        return read_scaling("1" if self.scale is None else self.scale)

    def _scale(self) -> str:
        return read_scale("1" if self.scale is None else self.scale)


def _before(certificate: Certificate, scale: str) -> str:
    """The event of the boundary before this one, or half of the scale."""
    dynamic = _core.DynamicSum(certificate.P, certificate.Q, None, scale)
    earlier = [Fraction(row[0]) for row in dynamic.boundary_events()]
    below = [s for s in earlier if s < Fraction(scale)]
    return str(max(below)) if below else str(Fraction(scale) / 2)
