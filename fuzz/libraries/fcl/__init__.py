"""FCL, the Flexible Collision Library, in Python: parts on paths by its test of convex bodies."""

from minkref.fuzz.libraries.library import Library, Method

LIBRARY = Library(
    title="FCL",
    targets="fcl-",
    place=18,
    methods=(
        Method("fcl-collide", "FCL (python-fcl), collide of convex bodies: paths", "collide"),
        Method("fcl-distance", "FCL (python-fcl), distance of convex bodies: paths", "distance"),
    ),
    kind="python",
    program="fcl/adapter.py",
    source="python-fcl 0.7.0.11 (PyPI), with the FCL in its wheel",
    licence="BSD-3-Clause",
    home="fcl",
    has_program=False,
)
