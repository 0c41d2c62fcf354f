"""The interpreter's lock is free while C++ works: other threads run, and Ctrl-C is heard."""

from __future__ import annotations

import pickle
import re
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path

import pytest
from long_works import disc, double_cone, drum, star
from minkref import _core

BINDINGS = Path("bindings")
GUARDS = ("Released()", "Computing ", "computed(")
#: A number of steps that no input raises, or logarithmic in it.
QUICK = set(
    """
    __copy__ __deepcopy__ __len__ __reduce_ex__ __repr__ all any check components
    components_and_holes counts curves edge_of_P ee_pairs error exact_signs faces facet facets
    feature holes in_operands is_built is_empty is_point is_segment memory_limit name neighbours
    none number observation_1 pair_by_paper parent parts planes radii reuse ring_count ring_ends
    scale seconds set_memory_limit statistics track_count track_doubles track_integers tracks
    vertex_of_P vertices window word x y appendix_readings facet_readings paper_readings
    repair_readings space_update_readings
    """.split()
) | {"core_convex.cpp: edges", "core_index.cpp: edges", "core_index.cpp: area"}
#: What makes or reads objects of Python, one by one; and what calls functions with a guard.
OF_PYTHON = set(
    """
    __add__ __sub__ __init__ arrays columns drawing ring_states tight_passages written_rings
    """.split()
) | {"core_polygon_set.cpp: rings"}


def _closing(text: str, at: int, opening: str, closing: str) -> int:
    depth = 1
    for match in re.compile(r'"(?:\\.|[^"\\])*"|\'\\?.\'|.', re.DOTALL).finditer(text, at):
        depth += (match[0] == opening) - (match[0] == closing)
        if depth == 0:
            return match.start()
    raise ValueError("no end")


def _bodies(text: str, names: set[str]) -> Iterator[str]:
    for match in re.finditer(rf"\b(?:{'|'.join(sorted(names))})\(", text):
        end = _closing(text, match.end(), "(", ")") + 1
        if start := re.compile(r"\s*(?:const)?\s*\{").match(text, end):
            yield text[start.end() : _closing(text, start.end(), "{", "}")]


def _bound() -> Iterator[tuple[str, str, bool]]:
    """File and name of each binding, and whether it frees the lock, itself or by a function of its
    file."""
    for path in sorted([*BINDINGS.glob("*.cpp"), *BINDINGS.glob("*.hpp")]):
        text = path.read_text()
        for match in re.finditer(r"\.def(?:_static|_prop_ro)?\(", text):
            said = text[match.end() : _closing(text, match.end(), "(", ")")]
            name = re.match(r'\s*"?(\w+)', said)
            assert name, said
            code = re.sub(r'"(?:\\.|[^"\\])*"', "", said)
            called = set(re.findall(r"&?(?:\w+::)*\b([a-z]\w+)(?=\(|,|\))", code))
            parts = [code, *(_bodies(text, called) if called else [])]
            yield path.name, name[1], any(guard in part for part in parts for guard in GUARDS)


def test_each_function_that_loops_over_input_frees_the_lock() -> None:
    bound = list(_bound())
    assert len(bound) > 400
    held = {
        where
        for file, name, is_free in bound
        if not (is_free or {name, where := f"{file}: {name}"} & (QUICK | OF_PYTHON))
    }
    assert not held, f"give them Released(), or computed(): {sorted(held)}"


@contextmanager
def counted_turns() -> Iterator[list[int]]:
    """Counts how often another thread has had the lock; threads give it away of themselves only."""
    turns, over, before = [0], threading.Event(), sys.getswitchinterval()

    def count() -> None:
        while not over.is_set():
            turns[0] += 1
            time.sleep(0.0005)

    other = threading.Thread(target=count)
    sys.setswitchinterval(1000)
    other.start()
    try:
        yield turns
    finally:
        over.set()
        sys.setswitchinterval(before)
        other.join()


@cache
def cone() -> _core.PolyhedralSet:
    return _core.PolyhedralSet(double_cone(6000))


@cache
def saved() -> dict[str, bytes]:
    values = {"polyhedron": double_cone(20_000), "solid": cone(), "convex": drum(1500), "set": MANY}
    return {name: pickle.dumps(value) for name, value in values.items()}


@cache
def copied() -> _core.PolyhedralSet:
    return _core.PolyhedralSet(double_cone(6000))


@cache
def surface() -> _core.SumSurface:
    return cone().surface()


@cache
def total() -> _core.Sum:
    return _core.minkowski_sum(star(2), disc(20_000), "1")


MANY = disc(60_000)
WORKS: dict[str, Callable[[], object]] = {
    "polyhedron, one vertex for all": lambda: double_cone(40_000).with_shared_vertices(),
    "polyhedron, scaled": lambda: double_cone(40_000).scaled(("7/5", "3", "11/7")),
    "polyhedron, translated": lambda: double_cone(40_000).translated(("7/5", "3", "11/7")),
    "polyhedron, volume": lambda: double_cone(40_000).sextuple_volume(),
    "polyhedron, JSON": lambda: double_cone(40_000).canonical_json(),
    "polyhedron, points": lambda: double_cone(40_000).points(),
    "polyhedron, state": lambda: pickle.dumps(double_cone(40_000)),
    "polyhedron, from its state": lambda: pickle.loads(saved()["polyhedron"]),
    "solid": lambda: _core.PolyhedralSet(double_cone(6000)),
    "solid, volume": lambda: cone().volume,
    "solid, where a point lies": lambda: cone().locate((1, 2, 3)),
    "solid, whether it has a point": lambda: (1, 2, 3) in cone(),
    "solid, equality": lambda: cone() == copied(),
    "solid, hash": lambda: hash(cone()),
    "solid, state": lambda: pickle.dumps(cone()),
    "solid, from its state": lambda: pickle.loads(saved()["solid"]),
    "solid, points of its surface": lambda: surface().points(),
    "convex, equality": lambda: drum(1500) == drum(1501),
    "convex, hash": lambda: hash(drum(1500)),
    "convex, volume": lambda: drum(1500).volume,
    "convex, from its state": lambda: pickle.loads(saved()["convex"]),
    "set, area": lambda: MANY.area,
    "set, equality": lambda: MANY == disc(60_001),
    "set, hash": lambda: hash(MANY),
    "set, state": lambda: pickle.dumps(MANY),
    "set, from its state": lambda: pickle.loads(saved()["set"]),
    "set, box": lambda: MANY.bounding_box(),
    "set, where a point lies": lambda: MANY.locate((1, 2)),
    "set, negated": lambda: _core.negated(MANY),
    "set, its outside": lambda: _core.Outside(MANY),
    "sum, area": lambda: total().area,
}  # fmt: skip


@pytest.mark.parametrize("name", WORKS)
def test_other_threads_run_while_it_works(name: str) -> None:
    """One of some times: the other thread may wake too late on a busy machine."""
    WORKS[name]()  # makes the operands
    with counted_turns() as turns:
        for _ in range(20):
            before = turns[0]
            WORKS[name]()
            if turns[0] > before:
                return
    raise AssertionError("the other thread never ran")
