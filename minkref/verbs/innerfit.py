"""`minkref innerfit`: its options."""

from __future__ import annotations

from minkref.cli.verb import command_of
from minkref.verbs.erode_request import InnerFitInSpace, InnerFitRequest, without_disc

EXAMPLES = """Examples:

minkref innerfit glyph1204 g1 --scale 30

minkref innerfit sheet.wkt part.wkt -o places.svg

minkref innerfit sheet.wkt part.wkt --json

minkref innerfit housing.off part.off --passages -o places.off"""

TOLD = """\
The inner-fit polygon: all places of a part, never turned, at which it lies within the
    container, scaled by S about the origin: the erosion of the container by the part. On the
    boundary and at the exact fits beside it the part touches the container's boundary. A place is
    where the part's origin comes to lie. Exact, in canonical form."""

command = command_of("innerfit", TOLD, without_disc("innerfit", InnerFitRequest, InnerFitInSpace))
