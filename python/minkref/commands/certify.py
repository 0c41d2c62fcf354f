"""`minkref certify P Q -o FILE`: a proof of what minkref says, for those who do not trust it."""

from __future__ import annotations

import gzip
import sys
from fractions import Fraction
from pathlib import Path
from typing import Annotated

import typer

from minkref import _core
from minkref.certify.certificate import Certificate, NoProof
from minkref.documents import (
    Stopwatch,
    as_text,
    check_spares,
    check_writable,
    document,
    replacing,
    write_atomically,
)
from minkref.errors import Refusal, refusing
from minkref.exact import read_scale
from minkref.operand import read_operand
from minkref.options import Json, Schema
from minkref.signals import interruptible
from minkref.terminal import shown

EXAMPLES = """Examples:

minkref certify disc1 cells1815 -o sum.cert.json

minkref certify P.wkt Q.wkt --event 541/186 -o event.cert.json

minkref certify g1 g2 --from 1 --to 11/10 -o interval.cert.json.gz"""


def command(
    P: Annotated[str, typer.Argument(help="First operand, the scaled one: a file or a model.")],
    Q: Annotated[str, typer.Argument(help="Second operand: a file or a model.")],
    output: Annotated[
        Path,
        typer.Option("-o", help="FILE.cert.json or FILE.cert.json.gz; the case goes beside it."),
    ],
    scale: Annotated[
        str | None,
        typer.Option("--scale", metavar="S", help="The sum and its tight passages there [1]."),
    ] = None,
    event: Annotated[
        str | None,
        typer.Option(
            "--event",
            metavar="S",
            help="The event of the boundary there: what is below, at and above, and that there is "
            "none after --from [the event before, or half of S].",
        ),
    ] = None,
    from_scale: Annotated[
        str | None, typer.Option("--from", metavar="A", help="No event between A and --to.")
    ] = None,
    to_scale: Annotated[str | None, typer.Option("--to", metavar="B", help="See --from.")] = None,
    json: Json = False,
    schema: Schema = False,
) -> None:
    """Write a certificate (docs/certificates.md): a proof in steps that `minkref check`, or a
    checker of yours, follows without trusting minkref."""
    watch = Stopwatch()
    stem = _stem(output)
    case = output.with_name(f"{stem}.case.json")
    if (scale is not None and event is not None) or (to_scale is not None and event is not None):
        mend = "choose --scale S, --event S, or --from A --to B"
        raise Refusal("these options do not go together", "options", mend)
    with interruptible():
        first, second = read_operand(P), read_operand(Q)
        for path in (output, case):
            check_writable(path)
            check_spares(path, [first.file, second.file])
        operands = f"{first.name} and {second.name}"
        certificate = refusing(operands, lambda: Certificate(first.set, second.set))
        try:
            _claim(certificate, scale, event, from_scale, to_scale)
        except NoProof as error:
            mend = "`minkref events P Q --kind boundary` lists the events"
            raise Refusal(str(error), operands, mend, "no-proof") from error
        text = certificate.text(case.name, operands)
    write_atomically(case, certificate.case())
    _write(output, text)
    value = document(
        "certify",
        watch,
        output=str(output),
        case=str(case),
        bytes=len(text.encode()),
        claims=certificate.claims,
    )
    if json:
        sys.stdout.write(as_text(value))
    else:
        sys.stdout.write(
            f"{shown(str(output))}: {len(certificate.claims)} claims, {value['bytes']:,} bytes, "
            f"{value['seconds']:.2f} s\nits case: {shown(str(case))}\n"
            f"check it: minkref check {shown(str(output))}\n"
        )


def _stem(output: Path) -> str:
    for ending in (".cert.json.gz", ".cert.json"):
        if output.name.endswith(ending) and output.name != ending:
            return output.name.removesuffix(ending)
    mend = "name it FILE.cert.json, or FILE.cert.json.gz"
    raise Refusal("this is no name for a certificate", str(output), mend)


def _claim(
    certificate: Certificate,
    scale: str | None,
    event: str | None,
    from_scale: str | None,
    to_scale: str | None,
) -> None:
    if event is not None:
        s = read_scale(event, "--event")
        a = read_scale(from_scale, "--from") if from_scale else _before(certificate, s)
        if Fraction(a) >= Fraction(s):
            raise Refusal("this is not below the event", "--from", "give a smaller scale")
        certificate.event(s, "boundary", a)
    elif from_scale is not None or to_scale is not None:
        if from_scale is None or to_scale is None:
            raise Refusal("an interval has two ends", "options", "give both --from and --to")
        a, b = read_scale(from_scale, "--from"), read_scale(to_scale, "--to")
        if Fraction(a) >= Fraction(b):
            raise Refusal("the interval is empty", "--to", "give a larger scale than --from")
        certificate.interval(a, b)
    else:
        certificate.sum(read_scale(scale or "1"), passages=True)


def _before(certificate: Certificate, scale: str) -> str:
    """The event of the boundary before this one, or half of the scale."""
    dynamic = _core.DynamicSum(certificate.P, certificate.Q, None, scale)
    earlier = [Fraction(row[0]) for row in dynamic.boundary_events()]
    below = [s for s in earlier if s < Fraction(scale)]
    return str(max(below)) if below else str(Fraction(scale) / 2)


def _write(output: Path, text: str) -> None:
    if output.suffix != ".gz":
        write_atomically(output, text)
        return
    with replacing(output) as part:
        part.write_bytes(gzip.compress(text.encode(), mtime=0))
