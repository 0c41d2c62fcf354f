"""iOverlay, in Rust: unions and offsets, no sums."""

from minkref.fuzz.libraries.library import Library, Method

LIBRARY = Library(
    title="iOverlay",
    targets="i-overlay",
    place=16,
    methods=(
        Method("i-overlay", "iOverlay, union of one set after the other", "union"),
        Method("i-overlay-outline", "iOverlay, outline with round joins: offsets", "outline"),
    ),
    kind="rust",
    program="i_overlay/adapter.rs",
    source="i_overlay 9.1.0 (crates.io)",
    licence="MIT",
    home="i-overlay",
    has_program=False,
)
