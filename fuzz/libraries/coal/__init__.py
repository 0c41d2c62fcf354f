"""Coal (once HPP-FCL): parts on paths by its test of convex bodies."""

from minkref.fuzz.libraries.library import Library, Method

LIBRARY = Library(
    title="Coal",
    targets="coal-",
    place=19,
    methods=(
        Method("coal-collide", "Coal, collide of convex bodies: paths", "collide"),
        Method("coal-distance", "Coal, distance of convex bodies: paths", "distance"),
    ),
    kind="python",
    program="coal/adapter.py",
    source="coal 3.0.3 (PyPI), with the Coal of libcoal's wheel",
    licence="BSD-2-Clause",
    home="coal",
    has_program=False,
)
