"""minkref without exactness, as one more library."""

from minkref.fuzz.libraries.library import Adapter, Library

PROGRAM, LICENCE = "minkref/adapter.py", "Apache-2.0"


def _adapter(name: str, title: str, arithmetic: str) -> Adapter:
    return Adapter(name, title, "own", PROGRAM, "this package", LICENCE, (arithmetic,))


LIBRARY = Library(
    title="minkref",
    targets="minkref",
    place=7,
    adapters=(
        _adapter("minkref-double", "minkref in double arithmetic, without exactness", "double"),
        _adapter("minkref-mpfr53", "minkref in MPFR of 53 bits, without exactness", "mpfr:53"),
    ),
    has_program=False,
)
