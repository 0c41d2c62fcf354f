"""The paper's own programs: Behar & Lien 2012, Sections 3, 4 and 6, followed literally."""

from minkref.fuzz.libraries.library import Library, Method
from minkref.fuzz.libraries.paper.program_name import CORRECTED, PREFIX, STATIC, read_name

ABOUT = "the paper's own program"
LISTED = ("double", "mpfr:53", "mpfr:200", "rational", f"rational,{CORRECTED}", f"double,{STATIC}")


def method(name: str) -> Method:
    """Refuses a name with an unknown arithmetic, word or reading."""
    read = read_name(name)
    return Method(name, f"{ABOUT}, {read.title}", read.argument)


LIBRARY = Library(
    title="the program of Behar & Lien 2012",
    targets=PREFIX,
    place=7,
    methods=tuple(method(f"{PREFIX}@{argument}") for argument in LISTED),
    kind="own",
    program="paper/adapter.py",
    source="this package",
    licence="Apache-2.0",
    has_program=False,
    read=method,
    in_all=False,
)
