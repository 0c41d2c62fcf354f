"""JTS, in Java: unions and offsets, no sums."""

from minkref.fuzz.libraries.library import Library, Method

LIBRARY = Library(
    title="JTS",
    targets="jts",
    place=15,
    methods=(
        Method("jts", "JTS, OverlayNGRobust: union of one set after the other", "union"),
        Method("jts-buffer", "JTS, buffer: offsets", "buffer"),
    ),
    kind="java",
    program="jts/Adapter.java",
    source="jts-core 1.20.0 (Maven Central)",
    licence="EDL-1.0 or EPL-2.0",
    home="jts",
    has_program=False,
)
