"""Values are copied and pickled by value; other objects refuse copying. No argument ends the
process."""

from __future__ import annotations

import copy
import multiprocessing
import pickle
import resource
import subprocess
import sys
import textwrap
from typing import Any

import minkref
import pytest
from minkref import _core

FRAME = minkref.read_text(
    "POLYGON((0 0,4 0,4 4,0 4,0 0),(1 1,1 2,2 2.5,2 1,1 1))", "wkt", source="frame"
)
BOW = _core.PolygonSet.from_json('{"polygons":[{"outer":[[0,0],[1,1],[1,0],[0,1]]}]}')
EMPTY = _core.PolygonSet.from_json('{"polygons":[]}')
CORNERS = [("0", "0", "0"), ("1/3", "0", "0"), ("0", "1", "0"), ("0", "0", "1")]
FACES = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
BOX = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
SOLID = _core.Polyhedron(CORNERS, FACES)
CONVEX = _core.ConvexPolyhedron(SOLID)
HOLLOW = minkref.polyhedral_sum(
    _core.Polyhedron(
        [(x, y, z) for at in ((0, 5), (1, 4)) for x in at for y in at for z in at],
        [[k + v for v in (ring[::-1] if k else ring)] for k in (0, 8) for ring in BOX],
    ),
    SOLID,
)
LONG = FRAME.scaled("1" * 9000).scaled("3" * 9000)  # longer than any reader takes
ROUND = [
    copy.copy,
    copy.deepcopy,
    *(lambda x, n=n: pickle.loads(pickle.dumps(x, n)) for n in range(2, 6)),
]


def of(value: Any) -> Any:
    if isinstance(value, _core.PolygonSet):
        return value.to_json(), value.vertices
    if isinstance(value, _core.PolyhedralSet):
        return value.canonical_json()
    surface = value.surface() if isinstance(value, _core.ConvexPolyhedron) else value
    return type(value), surface.points(), surface.rings()


@pytest.mark.parametrize(
    "value", [FRAME, BOW, EMPTY, LONG, SOLID, CONVEX, HOLLOW, _core.Polyhedron([], [])]
)
def test_a_value_is_copied_and_pickled_by_value(value: Any) -> None:
    for again in ROUND:
        assert of(again(value)) == of(value)
        (inside,) = again([value])
        assert of(inside) == of(value)
        if value is FRAME:
            assert inside.canonical_json() == value.canonical_json()


def test_a_sum_is_copied_and_its_region_pickled() -> None:
    found = minkref.minkowski_sum(FRAME, FRAME)
    assert copy.deepcopy(found).region.to_json() == copy.copy(found).region.to_json()
    assert of(pickle.loads(pickle.dumps(found.region))) == of(found.region)
    with pytest.raises(TypeError, match="a Sum cannot be pickled; pickle its region"):
        pickle.dumps(found)


def test_sets_go_to_other_processes() -> None:
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        assert list(map(of, pool.map(copy.copy, [FRAME, EMPTY]))) == [of(FRAME), of(EMPTY)]


@pytest.mark.parametrize(
    "make",
    [
        lambda: _core.ScaleIndex(FRAME, FRAME, "1", "2"),
        lambda: _core.DynamicSum(FRAME, FRAME, "1", "2"),
        lambda: _core.DynamicConvexSum(CONVEX, CONVEX, ("1", "1", "1")),
        lambda: _core.Prover(FRAME, FRAME),
        lambda: _core.ScaleIndex(FRAME, FRAME, "1", "2").rings("1"),
    ],
)
def test_what_is_no_value_is_neither_copied_nor_pickled(make: Any) -> None:
    made = make()
    for again in ROUND:
        with pytest.raises(TypeError, match="cannot pickle"):
            again(made)


@pytest.mark.parametrize("state", [None, (), ("x", True), ("{}", True), (1, 2)])
def test_a_damaged_pickle_is_refused(state: Any) -> None:
    kinds: list[type] = [_core.PolygonSet, _core.Polyhedron, _core.ConvexPolyhedron]
    if state != ():  # no plane: the empty set
        kinds.append(_core.PolyhedralSet)
    for kind in kinds:
        made = kind.__new__(kind)
        with pytest.raises((TypeError, minkref.BadInput)):
            made.__setstate__(state)


def test_a_pickle_of_no_canonical_set_in_space_is_refused() -> None:
    state = HOLLOW.__getstate__()
    normal, offset, polygons = state[0]
    double = (tuple(str(2 * int(axis)) for axis in normal), offset, polygons)
    turned = [[ring[::-1] for ring in rings] for rings in polygons]
    for damaged in (
        state[::-1], [state[0], state[0]], [double], [(("0", "0", "0"), offset, polygons)],
        [(("1/2", "0", "0"), offset, polygons)], [(normal, offset, turned)],
        [(normal, offset, [])], [(normal, offset, [[]])], [(normal, offset, [[[("0", "0")]]])],
        [(normal, "x", polygons)],
    ):  # fmt: skip
        made = _core.PolyhedralSet.__new__(_core.PolyhedralSet)
        with pytest.raises(minkref.BadInput):
            made.__setstate__(damaged)


@pytest.mark.parametrize("error", [minkref.BadInput, minkref.Refusal])
def test_refusals_are_pickled(error: type[Exception]) -> None:
    call = (lambda: FRAME.scaled("x")) if error is minkref.BadInput else None
    with pytest.raises(error) as raised:
        call() if call else minkref.set_memory_limit(0)
    again = pickle.loads(pickle.dumps(raised.value))
    assert (type(again), str(again)) == (type(raised.value), str(raised.value))
    assert again.code == raised.value.code  # type: ignore[attr-defined]


@pytest.mark.parametrize(
    ("faces", "code"),
    [
        ([[0, 1, 99]], "index-out-of-range"),
        ([[0, 1, 2], [2**32 - 1, 0, 1]], "index-out-of-range"),
        ([[]], "too-few-vertices"),
        ([[0, 1]], "too-few-vertices"),
    ],
)
def test_a_polyhedron_has_no_face_that_names_no_vertex(faces: Any, code: str) -> None:
    with pytest.raises(minkref.BadInput) as error:
        _core.Polyhedron(CORNERS, faces)
    assert error.value.code == code


def run(code: str, most: int | None = None) -> subprocess.CompletedProcess[str]:
    def limit() -> None:
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        if most is not None:
            resource.setrlimit(resource.RLIMIT_AS, (most, most))

    return subprocess.run(
        [sys.executable, "-c", textwrap.dedent(code)],
        capture_output=True,
        text=True,
        timeout=120,
        preexec_fn=limit,
    )


def test_numbers_that_need_more_memory_than_there_is_raise() -> None:
    """GMP by itself ends the process."""
    ran = run(
        """
        import resource
        from minkref import _core
        n = "7" * 4_000_000
        long = _core.PolygonSet.__new__(_core.PolygonSet)
        corners = f'[[0,0],["{n}",0],[1,"{n}"]]'
        long.__setstate__((f'{{"polygons":[{{"outer":{corners}}}]}}', False))
        used = int(open("/proc/self/statm").read().split()[0]) * 4096
        resource.setrlimit(resource.RLIMIT_AS, (used + (1 << 20), -1))
        try:
            long.area()
        except MemoryError:
            print("no memory")
        resource.setrlimit(resource.RLIMIT_AS, (-1, -1))
        print(long.vertices, long.translated("1", "0").vertices)
        """
    )
    assert (ran.returncode, ran.stdout) == (0, "no memory\n3 3\n"), ran.stderr[-400:]


@pytest.mark.parametrize("threads", [0, 1, 1024])
def test_threads_that_cannot_start_are_done_without(threads: int) -> None:
    """The limit on processes of the user, or on the memory for their stacks."""
    ran = run(
        f"""
        import resource
        from minkref import _core
        P = _core.PolygonSet.from_json('{{"polygons":[{{"outer":[[0,0],[1,0],[0,1]]}}]}}')
        index = _core.ScaleIndex(P, P, "1", "2", {threads})
        used = int(open("/proc/self/statm").read().split()[0]) * 4096
        resource.setrlimit(resource.RLIMIT_AS, (used + (6 << 20),) * 2)
        print(len(index.batch(["3/2"] * 4000, "double", {threads})))
        """
    )
    assert (ran.returncode, ran.stdout) == (0, "4000\n"), ran.stderr[-400:]


@pytest.mark.parametrize("threads", [1025, 4_000_000_000, 2**32 - 1])
def test_too_many_threads_are_refused(threads: int) -> None:
    index = _core.ScaleIndex(FRAME, FRAME, "1", "2")
    for call in (
        lambda: index.batch(["1"], "double", threads),
        lambda: index.batch([], "double", threads),
        lambda: _core.ScaleIndex(FRAME, FRAME, "1", "2", threads),
    ):
        with pytest.raises(minkref.BadInput, match="at most 1024"):
            call()


@pytest.mark.parametrize(
    ("end", "code"),
    [("raise RuntimeError('mine')", 1), ("sys.exit(3)", 3), ("pass", 0),
     ("signal.raise_signal(signal.SIGINT)", -2)],
)  # fmt: skip
def test_the_end_of_a_program_says_nothing_of_ours(end: str, code: int) -> None:
    """Tests objects that are alive at the end, even in a running thread."""
    ran = run(
        f"""
        import minkref, signal, sys, threading, time
        P = minkref.read_text("POLYGON((0 0,1 0,0 1,0 0))", "wkt")
        threading.Thread(target=lambda P=P: time.sleep(60), daemon=True).start()
        circle = [minkref.minkowski_sum(P, P)]
        circle.append(circle)
        {end}
        """
    )
    assert ran.returncode == code
    assert "nanobind" not in ran.stderr and "leaked" not in ran.stderr
