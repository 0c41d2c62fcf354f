"""One work for each function that can take long, for signals and memory limits to end: a second and
more if the run is thorough, otherwise two fifths of the size."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from math import cos, pi, sin

from minkref import _core
from thoroughness import draws

SCALING = ("1", "3/2", "7/5")
SIXTY = draws(24_000, 60_000)
MESH, STL, MANY, ROUND = (draws(n * 40_000, n * 100_000) for n in (4, 1, 8, 6))


def _set(ring: list[tuple[int, int]]) -> _core.PolygonSet:
    text = ",".join(f"[{x},{y}]" for x, y in ring)
    return _core.PolygonSet.from_json(f'{{"polygons":[{{"outer":[{text}],"holes":[]}}]}}')


@cache
def star(spikes: int, radius: int = 1_000_000) -> _core.PolygonSet:
    """Long spikes all around: nearly every edge meets nearly every other."""
    angles = [pi * k / spikes for k in range(2 * spikes)]
    radii = [radius if k % 2 else radius // 3 for k in range(2 * spikes)]
    return _set(
        [(round(r * cos(a)), round(r * sin(a))) for r, a in zip(radii, angles, strict=True)]
    )


@cache
def points(spikes: int) -> list[tuple[object, object]]:
    """A star's corners, as fractions."""
    return star(spikes, 10**9).rings()[0][0]


@cache
def disc(corners: int, radius: int = 1_000_000) -> _core.PolygonSet:
    angles = [2 * pi * k / corners for k in range(corners)]
    return _set([(round(radius * cos(a)), round(radius * sin(a))) for a in angles])


@cache
def comb(teeth: int) -> _core.PolygonSet:
    ring = [(0, -1), (4 * teeth, -1 - teeth)]
    for k in reversed(range(teeth)):
        ring += [(4 * k + 3, 1), (4 * k + 2, 40 + 3 * k), (4 * k + 1, 1 + k % 2)]
    return _set(ring)


@cache
def drum(sides: int) -> _core.ConvexPolyhedron:
    """A prism over a regular polygon, nearly: convex, with so many facets and two."""
    n, radius = sides, 10**12
    ring = [(round(radius * cos(2 * pi * k / n)), round(radius * sin(2 * pi * k / n)))
            for k in range(n)]  # fmt: skip
    points = [(str(x), str(y), str(z)) for z in (0, 1) for x, y in ring]
    walls = [[k, (k + 1) % n, n + (k + 1) % n, n + k] for k in range(n)]
    caps = [list(reversed(range(n))), list(range(n, 2 * n))]
    return _core.ConvexPolyhedron(_core.Polyhedron(points, walls + caps))


@cache
def double_cone(corners: int) -> _core.Polyhedron:
    """A cone over a star and another below: slivers whose boxes overlap everywhere."""
    ring = star(corners // 2, 10**9).rings()[0][0]
    points: list[tuple[object, ...]] = [(x, y, 0) for x, y in ring]
    points += [(0, 0, 10**9), (0, 0, -(10**9))]
    faces = [[k, (k + 1) % corners, corners] for k in range(corners)]
    faces += [[(k + 1) % corners, k, corners + 1] for k in range(corners)]
    return _core.Polyhedron(points, faces)


@cache
def star_prism(corners: int) -> _core.Polyhedron:
    """Two faces of so many corners, and walls that boxes do not tell apart."""
    ring = star(corners // 2, 10**9).rings()[0][0]
    points = [(x, y, z) for z in (0, 1) for x, y in ring]
    walls = [[k, (k + 1) % corners, corners + (k + 1) % corners, corners + k]
             for k in range(corners)]  # fmt: skip
    caps = [list(reversed(range(corners))), list(range(corners, 2 * corners))]
    return _core.Polyhedron(points, walls + caps)


@cache
def cone_text(corners: int) -> bytes:
    """A double cone over a star, as OFF."""
    n = corners
    lines = [f"OFF {n + 2} {2 * n} 0"]
    lines += [f"{x} {y} 0" for x, y in star(n // 2, 10**9).rings()[0][0]]
    lines += ["0 0 1", "0 0 -1"]
    lines += [f"3 {k} {(k + 1) % n} {n}\n3 {(k + 1) % n} {k} {n + 1}" for k in range(n)]
    return "\n".join(lines).encode()


@cache
def mesh_text(form: str) -> bytes:
    """A mesh that takes long to read. STL writes each corner six times."""
    text = cone_text(STL if form == "stl" else MESH)
    if form == "off":
        return text
    return _core.write_mesh(_core.read_mesh_text(text, "off")[0], form).encode()


@cache
def many() -> _core.PolygonSet:
    """Vertices whose coordinates no decimal ends."""
    return disc(MANY).scaled("1000/3001")


@cache
def written() -> str:
    return _core.write(many(), "wkt")


@cache
def slanted(corners: int) -> _core.Polyhedron:
    """A cone of so many facets over a star with integer corners."""
    ring = star(corners // 2, 1000).rings()[0][0]
    points: list[tuple[object, ...]] = [(x, y, y) for x, y in ring]
    points.append((0, 0, 3000))
    sides = [[k, (k + 1) % corners, corners] for k in range(corners)]
    return _core.Polyhedron(points, [*sides, list(reversed(range(corners)))])


def update_in_space(arithmetic: str) -> _core.PaperSpaceUpdate:
    corrected = {name: value for name, _, value, _ in _core.space_update_readings()}
    return _core.PaperSpaceUpdate(double_cone(12), slanted(14), "1", arithmetic, corrected)


@cache
def answered_in_space() -> tuple[_core.PaperSpaceUpdate, _core.PaperSpaceSum]:
    update = update_in_space("mpfr:53")
    return update, update.sum()


def update_with_disc() -> _core.DiscUpdate:
    corrected = {name: value for name, _, value, _ in _core.appendix_readings()}
    return _core.DiscUpdate(star(100), "4", "1", "rational", corrected)


@cache
def slots(count: int) -> _core.Features:
    """Slots, all alike, in one block: each leaf is as deep as all others."""
    ring = [(0, 0), (2 * count + 1, 0), (2 * count + 1, 5)]
    for k in range(2 * count - 1, 0, -2):
        ring += [(k + 1, 5), (k + 1, 2), (k, 2), (k, 5)]
    return _core.features(_set([(2 * x - y, x + 2 * y) for x, y in [*ring, (0, 5)]]))


def _scene(copies: int, scales: int) -> object:
    """Copies with so many scales, each of which meets many others."""
    rows = [
        (0, f"{9 + k % scales}/9", str(200_000 * k % 7_000_001), str(70_000 * k % 5_000_001))
        for k in range(copies)
    ]
    return _core.SceneUnion(star(20), [comb(20).scaled("10000")], rows, True)


def _proof(P: _core.PolygonSet, Q: _core.PolygonSet) -> object:
    prover = _core.Prover(P, Q)
    return prover.prove("1", prover.box("1"), (0, 1))


def prepare(name: str) -> None:
    """Makes the operands, which do not belong to the measured work."""
    if name in ("reading", "writing"):
        written()
    elif name.startswith("reading "):
        mesh_text(name.removeprefix("reading "))
    elif name in ("validation, slivers", "certified as convex", "a solid"):
        double_cone(SIXTY)
    elif name in ("validation, large faces", "cut into triangles"):
        star_prism(SIXTY)
    elif name == "validation":
        disc(ROUND)
    elif name == "decision":
        disc(20_000), disc(20_001)
    elif name == "convex sum":
        drum(1500), drum(1501)
    elif name == "validation, spikes":
        star(SIXTY, 10**9)
    elif name == "the exact sum beside that of the paper":
        answered_in_space()
    elif name == "a set of points":
        points(SIXTY)
    elif name == "features, where to cut":
        slots(draws(300, 700))


def works() -> dict[str, Callable[[], object]]:
    """Each call computes what it names, for a second at the least."""
    large, small = star(110), comb(60)
    return {
        "sum, paper": lambda: _core.minkowski_sum(star(200), comb(150), "1"),
        "sum, winding": lambda: _core.minkowski_sum(star(200), comb(150), "1", "winding"),
        "sum, definition": lambda: _core.minkowski_sum(large, small, "1", "definition"),
        "sum, mpfr": lambda: _core.minkowski_sum(large, small, "1", "paper", "mpfr:200"),
        "erosion": lambda: _core.erosion(star(200), comb(150).scaled("900"), "1"),
        "closing": lambda: _core.closing(star(200), comb(150), "1"),
        "inset": lambda: _core.inset(star(draws(800, 2000)), "1000000"),
        "tight passages": lambda: _core.tight_passages(star(200), comb(150), "1"),
        "pair events": lambda: _core.pair_events(star(400), comb(300)),
        "arrangement events": lambda: _core.ArrangementEvents(large, small),
        "dynamic sum": lambda: _core.DynamicSum(large, small, "1/2", "2"),
        "index": lambda: _core.ScaleIndex(star(300), comb(250), "1/2", "2"),
        "scene, sums": lambda: _scene(40, 40),
        "scene, contacts": lambda: _scene(draws(800, 2500), 1),
        "proof of a sum": lambda: _proof(star(80), comb(60)),
        "decision": lambda: _core.decide(disc(20_000), disc(20_001), "1", "0", "0"),
        "validation": lambda: disc(ROUND).validate(),
        "reading": lambda: _core.read_text(written(), "wkt"),
        "validation, spikes": lambda: star(SIXTY, 10**9).validate(),
        "validation, slivers": lambda: double_cone(SIXTY).validate(),
        "validation, large faces": lambda: star_prism(SIXTY).validate(),
        "a solid": lambda: _core.PolyhedralSet(double_cone(SIXTY)),
        "certified as convex": lambda: _core.ConvexPolyhedron(double_cone(SIXTY)),
        "a set of points": lambda: _core.PolygonSet(points(SIXTY)),
        **{
            f"reading {form}": lambda form=form: _core.read_mesh_text(mesh_text(form), form)
            for form in _core.MESH_FORMATS
        },
        "cut into triangles": lambda: star_prism(SIXTY).cut_into_triangles(),
        "writing": lambda: _core.write(many(), "wkt"),
        "long lists": lambda: _core.reduced_convolution(star(2000), comb(2000)),
        "the paper, update in space": lambda: update_in_space("rational"),
        "the exact sum beside that of the paper": lambda: answered_in_space()[0].beside_exact(
            answered_in_space()[1], "0"
        ),
        "the paper, update with a disc": update_with_disc,
        "features": lambda: _core.features(comb(draws(300, 700))),
        "features, where to cut": lambda: slots(draws(300, 700)).notches("1/10", "0"),
        "convex sum": lambda: _core.convex_sum(drum(1500), drum(1501), SCALING, "brute-force"),
    }
