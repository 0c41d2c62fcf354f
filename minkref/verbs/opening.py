"""`minkref opening`: its options."""

from __future__ import annotations

from minkref.cli.verb import command_of
from minkref.verbs.erode_request import morphology

EXAMPLES = """Examples:

minkref opening glyph1204 g1 --scale 30

minkref opening P.wkt tool.wkt -o reached.svg

minkref opening P.wkt tool.wkt -o reached.wkt --json

minkref opening glyph1204 disc:7/5 -o reached.svg

minkref opening glyph1204 disc:7/5 -o reached.wkt --tolerance 1/1000

minkref opening housing.off part.off -o reached.off"""

TOLD = """\
The opening of P, scaled by S about the origin, by Q: all copies of Q within the scaled P
    together, that is, the erosion by Q plus Q. Copies that fit exactly count. Exact, in canonical
    form. Q may be a disc about the origin, as disc:7/5. In space copies that fit exactly are left
    out."""

command = command_of("opening", TOLD, morphology("opening"))
