"""Random scenes before CGAL's join, the slow engine and points decided copy by copy."""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cache

from minkref import Copy, PolygonSet, Scene, _core
from minkref.fuzz.judges.plane.slow_scene import slow_scene
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.scenes.draws import DrawnScene, drawn
from minkref.reports.evidence.scenes.joined import CgalSums, Joining

MINUTES = Minutes(0.1, 0.3, 1)

SCENES = Counts(24, 120, 500)
CHANGED = Counts(2, 6, 20)  # scenes that are changed
CHANGES = 100
MOST_VERTICES = 60  # of all placed shapes and the robot, for the slow engine
MOST_POINTS = 60  # decided of a scene


@dataclass
class Found:
    """A scene's faults by law, and how often each law was tried."""

    kind: str
    wrong: dict[str, list[str]] = field(default_factory=dict)
    tried: Counter[str] = field(default_factory=Counter)

    def check(self, law: str, is_right: bool, about: str, count: int = 1) -> None:
        self.tried[law] += count
        if not is_right:
            self.wrong.setdefault(law, []).append(about)


JOINED = "unions that are not CGAL's join of our sums"
OWN_SUMS = "unions that are not CGAL's join of its own sums"
SLOW = "unions or tight passages that are not the slow engine's"
POINTS = "points that the copies decide otherwise"
ANEW = "changes that do not give the scene made anew"
NO_SUM = "scenes in which CGAL has no sum"
UNSOUND = "scenes in which a sum of CGAL's is wrong"
BACK = "changes and back that do not give the scene from before"


def examined(task: tuple[int, bool]) -> Found:
    index, is_changed = task
    one = drawn(index)
    found = Found(one.kind)
    scene = one.scene(passages=True)
    _by_cgal(one, scene, found)
    _by_slow_engine(one, scene, found)
    _by_points(one, scene, found)
    if is_changed:
        _by_changes(one, scene, found)
    return found


def _by_cgal(one: DrawnScene, scene: Scene, found: Found) -> None:
    """CGAL joins our sums, then, if all exist and none has a fault, CGAL's sums."""
    join, sums = _cgal()
    ours = [scene.sum_of(k) for k in range(len(one.copies))]
    united = scene.union()
    found.check(JOINED, join.join(ours)[0] == united, one.name)
    if not one.robot.is_region:
        return
    theirs = []
    for copy, our in zip(one.copies, ours, strict=True):
        shape = one.shapes[int(copy.shape)]
        answer = sums.sum(shape, copy.scale, one.robot.scaled("-1")) if shape.is_region else None
        if answer is None:
            found.tried[NO_SUM] += 1
            return
        placed = answer[0].translated(*map(str, copy.place))
        if _core.combined("union", [placed])[0] != our:
            found.tried[UNSOUND] += 1
            return
        theirs.append(placed)
    found.check(OWN_SUMS, join.join(theirs)[0] == united, one.name)


@cache
def _cgal() -> tuple[Joining, CgalSums]:
    """Of this process."""
    return Joining(), CgalSums()


def _by_slow_engine(one: DrawnScene, scene: Scene, found: Found) -> None:
    vertices = one.robot.vertices + sum(one.shapes[int(c.shape)].vertices for c in one.copies)
    if not one.is_degenerate or vertices > MOST_VERTICES:
        return
    copies = [(int(c.shape), c.scale, c.place) for c in one.copies]
    slow = slow_scene(one.robot, one.shapes, copies)
    passages = [list(passage.points) for passage in scene.passages()]
    same = (slow.digest, slow.components, slow.holes, slow.tight) == (
        scene.digest, scene.components, scene.holes, passages,
    )  # fmt: skip
    found.check(SLOW, same, one.name)


def _by_points(one: DrawnScene, scene: Scene, found: Found) -> None:
    """At vertices and middles of sides some copy touches and no copy overlaps."""
    if not one.robot.is_region:
        return
    turned = one.robot.scaled("-1")
    dice = random.Random(one.name)
    sides = list(_sides(scene))
    points = [a for a, _ in sides]
    points += [((a[0] + b[0]) / 2, (a[1] + b[1]) / 2) for a, b in sides]
    points = dice.sample(points, min(len(points), MOST_POINTS))
    for x, y in points:
        contacts = {_contact(one, turned, copy, x, y) for copy in one.copies}
        found.check(POINTS, "overlapping" not in contacts and "touching" in contacts,
                    f"{one.name} at ({x}, {y})")  # fmt: skip


def _contact(one: DrawnScene, turned: PolygonSet, copy: Copy, x: Fraction, y: Fraction) -> str:
    at = (str(x - copy.place[0]), str(y - copy.place[1]))
    shape = one.shapes[int(copy.shape)]
    return str(_core.decide(shape, turned, str(copy.scale), *at)["contact"])


Side = tuple[tuple[Fraction, Fraction], tuple[Fraction, Fraction]]


def _sides(scene: Scene) -> Iterator[Side]:
    for polygon in scene.union().rings():
        for ring in polygon:
            for k, (x, y) in enumerate(ring):
                before = ring[k - 1]
                yield (Fraction(before[0]), Fraction(before[1])), (Fraction(x), Fraction(y))


def _by_changes(one: DrawnScene, scene: Scene, found: Found) -> None:
    """A walk of changes, now and then held against the scene made anew; then all of them back."""
    dice = random.Random(f"{one.name} changes")
    walk, undo = scene, []
    for step in range(CHANGES):
        at = dice.randrange(len(one.copies))
        old = walk.copies[at]
        other = dice.choice(one.copies)
        scale = other.scale if dice.random() < 0.5 else old.scale * Fraction(9, 8)
        undo.append((at, old))
        walk = walk.change(at, scale, other.place if scale == old.scale else old.place)
        if step % 20 == 19:
            anew = Scene(one.robot, list(one.shapes), list(walk.copies), passages=True)
            found.check(ANEW, _all_of(walk) == _all_of(anew), f"{one.name}, step {step}", 20)
    for at, old in reversed(undo):
        walk = walk.change(at, old.scale, old.place)
    found.check(BACK, _all_of(walk) == _all_of(scene), one.name, CHANGES)


def _all_of(scene: Scene) -> tuple[object, ...]:
    return scene.digest, scene.components, scene.holes, scene.owners(), scene.passages()


def run(findings: Findings, size: Size) -> None:
    count, changed = size.of(SCENES), size.of(CHANGED)
    every = count // changed
    tasks = [(index, index % every == 0) for index in range(count)]
    wrong: dict[str, list[str]] = {}
    tried: Counter[str] = Counter()
    kinds: Counter[str] = Counter()
    for found in in_processes(examined, tasks, 20, "scenes"):
        kinds[found.kind] += 1
        tried.update(found.tried)
        for law, about in found.wrong.items():
            wrong.setdefault(law, []).extend(about)
    findings.figures["scenes by kind"] = dict(kinds)
    findings.note(
        f"{count} scenes, of them " + ", ".join(f"{n} of {kind}" for kind, n in kinds.items())
    )
    findings.note("; ".join(f"{what}: {tried[what]}" for what in (NO_SUM, UNSOUND)))
    for law in (JOINED, OWN_SUMS, SLOW, POINTS, ANEW, BACK):
        findings.none(f"{law}, of {tried[law]:,}", wrong.get(law, []))
        findings.law(f"{law}: tried", tried[law] > 0, "some", tried[law])
