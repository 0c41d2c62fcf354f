"""`minkref certify P Q -o FILE`: its options, in the plane and in space."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Annotated

import typer
from minkref.cli.memory import Memory
from minkref.cli.options import READ_SCALE, FirstOperand, Json, SecondOperand
from minkref.cli.request import Read
from minkref.cli.verb import Verb, command_of
from minkref.exact import read_point, read_space_point
from minkref.scaling import PlaneScale, Scaling, read_plane_scale, read_scaling
from minkref.settings import PLANE, SPACE

EXAMPLES = """Examples:

minkref certify disc1 cells1815 -o sum.cert.json

minkref certify P.wkt Q.wkt --event 541/186 -o event.cert.json

minkref certify P.wkt Q.wkt --degeneracy 541/186 -o zero.cert.json

minkref certify P.wkt Q.wkt --scale 2 --point 1/3,5 -o point.cert.json

minkref certify g1 g2 --from 1 --to 11/10 -o interval.cert.json.gz

minkref certify g1 g2 --events --from 1 --to 2 -o events.cert.json

minkref certify g1 g2 --scale 7/5 -o sum.cert.json --theorem sum.v

minkref certify g1 g2 --scale 2,1/3 -o sum.cert.json

minkref certify gs3 rod --scale 2,1/3,5 -o convex.cert.json

minkref certify P.off Q.stl --scale 7/5 -o solids.cert.json

minkref certify P.off Q.stl --scale 7/5 --point 1/3,5,2 -o point.cert.json"""

TOLD = """\
Write a certificate: a proof in steps that `minkref check`, or your own checker, verifies
without trusting minkref (docs/certificates.md; for convex polyhedra
docs/certificates-convex.md, for others docs/certificates-solids.md). It is checked before it is
written; a certificate that is not a proof would be a fault of minkref, and is not written."""

Output = Annotated[
    Path,
    typer.Option("-o", help="FILE.cert.json or FILE.cert.json.gz; the case is written next to it."),
]
SCALE = typer.Option(
    "--scale",
    metavar="S",
    help="Prove the sum and its tight passages at S. Default: 1. Or a factor for each axis: SX,SY "
    "in the plane, SX,SY,SZ in space.",
)
ScaleInPlane = Annotated[PlaneScale | None, SCALE, Read(read_plane_scale)]
ScaleInSpace = Annotated[Scaling | None, SCALE, Read(read_scaling)]
Event = Annotated[
    Fraction | None,
    typer.Option(
        "--event",
        metavar="S",
        help="Prove the topology event at S, or else the boundary event: the sum below, at "
        "and above S, and that there is no event between --from (default: the event before, "
        "or half of S) and S.",
    ),
    READ_SCALE,
]
Begin = Annotated[
    Fraction | None,
    typer.Option("--from", metavar="A", help="Prove that there is no event between A and --to."),
    READ_SCALE,
]
End = Annotated[Fraction | None, typer.Option("--to", metavar="B", help="See --from."), READ_SCALE]
Events = Annotated[
    bool,
    typer.Option(
        "--events",
        help="Prove all boundary events between --from and --to, and that no other is between "
        "them. Events at --from or --to themselves are not listed.",
    ),
]
AllPassages = Annotated[
    bool,
    typer.Option(
        "--all-passages",
        help="Prove also that the sum at --scale has no other tight passages than those listed.",
    ),
]
Degeneracy = Annotated[
    Fraction | None,
    typer.Option(
        "--degeneracy",
        metavar="S",
        help="Prove what makes S critical: which edges of the convolution meet there, as "
        "predicates that are zero at S, and their signs below and above.",
    ),
    READ_SCALE,
]
POINT = typer.Option(
    "--point", metavar="X,Y[,Z]", help="Prove only whether this point is in the sum at --scale."
)
Point = Annotated[tuple[str, str] | None, POINT, Read(read_point)]
PointInSpace = Annotated[tuple[str, str, str] | None, POINT, Read(read_space_point)]
Check = Annotated[
    bool,
    typer.Option(
        "--check/--no-check",
        help="Check the certificate before it is written, as `minkref check` does. Takes "
        "about as long as making it.",
    ),
]
Theorem = Annotated[
    Path | None,
    typer.Option(
        "--theorem",
        metavar="FILE.v",
        help="Write the sum at --scale, or the --point, as a theorem of Coq too, proved by "
        "computation (docs/proved.md; `make proofs` builds what it takes).",
    ),
]


@dataclass(frozen=True)
class CertifyInPlane:
    P: FirstOperand
    Q: SecondOperand
    output: Output
    scale: ScaleInPlane = None
    event: Event = None
    from_scale: Begin = None
    to_scale: End = None
    events: Events = False
    degeneracy: Degeneracy = None
    all_passages: AllPassages = False
    point: Point = None
    check: Check = True
    theorem: Theorem = None
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class CertifyInSpace:
    P: FirstOperand
    Q: SecondOperand
    output: Output
    scale: ScaleInSpace = None
    point: PointInSpace = None
    check: Check = True
    memory: Memory = None
    json: Json = False


OF_PLANE = ("--event", "--events", "--from", "--to", "--degeneracy", "--all-passages")
command = command_of(
    "certify",
    TOLD,
    {
        PLANE: Verb(CertifyInPlane, "minkref.plane.commands.certify:run"),
        SPACE: Verb(
            CertifyInSpace,
            "minkref.space.commands.certify:run",
            why=dict.fromkeys(OF_PLANE, "there are certificates of sums and points only")
            | {"--theorem": "there are theorems of sums in the plane only"},
        ),
    },
)
