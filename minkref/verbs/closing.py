"""`minkref closing`: its options."""

from __future__ import annotations

from minkref.cli.verb import command_of
from minkref.verbs.erode_request import morphology

EXAMPLES = """Examples:

minkref closing glyph1204 g1 --scale 30

minkref closing P.wkt Q.wkt -o closed.svg

minkref closing P.wkt Q.wkt --scale 7/5 --json

minkref closing glyph1204 disc:7/5 -o closed.svg

minkref closing glyph1204 disc:7/5 -o closed.dxf

minkref closing housing.off part.off -o closed.off"""

TOLD = """\
The closing of P, scaled by S about the origin, by Q: the sum of the scaled P and Q, eroded
    by Q. Exact, in canonical form, with its remnants. Q may be a disc about the origin, as
    disc:7/5."""

command = command_of("closing", TOLD, morphology("closing"))
