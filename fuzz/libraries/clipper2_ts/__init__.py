"""Clipper2 in TypeScript, the npm package clipper2-ts."""

from minkref.fuzz.libraries.library import Library, Method

LIBRARY = Library(
    title="Clipper2 in TypeScript",
    targets="clipper2-ts",
    place=13,
    methods=(
        Method("clipper2-ts", "clipper2-ts, minkowskiSum of two rings (their curves)", "boundary"),
        Method("clipper2-ts-union", "clipper2-ts, union: unions", "union"),
        Method(
            "clipper2-ts-inflate", "clipper2-ts, inflatePaths with round joins: offsets", "inflate"
        ),
    ),
    kind="node",
    program="clipper2_ts/adapter.mjs",
    source="clipper2-ts 2.0.1 (npm)",
    licence="BSL-1.0",
    home="clipper2-ts",
    has_program=False,
)
