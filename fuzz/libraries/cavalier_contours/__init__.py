"""Cavalier Contours, in Rust: offsets of lines and arcs."""

from minkref.fuzz.libraries.library import Library, Method

LIBRARY = Library(
    title="Cavalier Contours",
    targets="cavalier-contours",
    place=17,
    methods=(
        Method("cavalier-contours", "Cavalier Contours, parallel_offset of a Shape: offsets"),
    ),
    kind="rust",
    program="cavalier_contours/adapter.rs",
    source="cavalier_contours 0.9.0 (crates.io)",
    licence="MIT or Apache-2.0",
    home="cavalier-contours",
    has_program=False,
)
