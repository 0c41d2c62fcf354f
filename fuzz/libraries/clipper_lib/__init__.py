"""Clipper 1 in JavaScript, the npm package clipper-lib."""

from minkref.fuzz.libraries.library import Library, Method

LIBRARY = Library(
    title="Clipper 1 in JavaScript",
    targets="clipper-lib",
    place=12,
    methods=(
        Method("clipper-lib", "clipper-lib, MinkowskiSum of two rings (their curves)", "boundary"),
        Method("clipper-lib-union", "clipper-lib, Execute: unions", "union"),
        Method(
            "clipper-lib-inflate", "clipper-lib, ClipperOffset with round joins: offsets", "inflate"
        ),
    ),
    kind="node",
    program="clipper_lib/adapter.mjs",
    source="clipper-lib 6.4.2 (npm)",
    licence="BSL-1.0",
    home="clipper-lib",
    has_program=False,
)
