"""JSTS, JTS in JavaScript: unions and offsets, no sums."""

from minkref.fuzz.libraries.library import Library, Method

LIBRARY = Library(
    title="JSTS",
    targets="jsts",
    place=14,
    methods=(
        Method("jsts", "JSTS, union of one set after the other", "union"),
        Method("jsts-buffer", "JSTS, buffer: offsets", "buffer"),
    ),
    kind="node",
    program="jsts/adapter.mjs",
    source="jsts 2.12.1 (npm)",
    licence="EDL-1.0 or EPL-1.0",
    home="jsts",
    has_program=False,
)
