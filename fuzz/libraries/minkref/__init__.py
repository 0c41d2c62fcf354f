"""minkref without exactness, as one more library."""

from minkref.fuzz.libraries.library import Library, Method

LIBRARY = Library(
    title="minkref",
    targets="minkref",
    place=8,
    methods=(
        Method("minkref-double", "minkref in double arithmetic, without exactness", "double"),
        Method("minkref-mpfr53", "minkref in MPFR of 53 bits, without exactness", "mpfr:53"),
    ),
    kind="own",
    program="minkref/adapter.py",
    source="this package",
    licence="Apache-2.0",
    has_program=False,
)
