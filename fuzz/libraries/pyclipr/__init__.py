"""pyclipr, a Python package of Clipper2."""

from minkref.fuzz.libraries.library import Library, Method

LIBRARY = Library(
    title="pyclipr",
    targets="pyclipr",
    place=11,
    methods=(
        Method("pyclipr-inflate", "Clipper2 (pyclipr), ClipperOffset with round joins: offsets"),
    ),
    kind="python",
    program="pyclipr/adapter.py",
    source="pyclipr 0.1.8 (PyPI), with the Clipper2 in its wheel",
    licence="BSD-2-Clause (wrapper), BSL-1.0 (Clipper2)",
    home="pyclipr",
    has_program=False,
)
