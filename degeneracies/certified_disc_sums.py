"""Draws certificates of sums with a disc (docs/certificates-disc.md), and false ones."""

from __future__ import annotations

import copy
import itertools
import json
import random
from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.certify.disc.disc_sum_certificate import DiscSumCertificate
from minkref.degeneracies.catalogue import DISC_FAMILIES
from minkref.degeneracies.disc.case_document import DegenerateWithDisc
from minkref.exact import digest
from minkref.fuzz.features.place_draws import drawn_set, set_of

Value = dict[str, Any]
Dice = random.Random
FREE = [None, "free", None]


def drawn_certificate(seed: int, number: int) -> DiscSumCertificate:
    """Every fourth number a member of a family of degenerate cases, else a drawn set: a third of
    these at a radius of an event. Three points are claimed, too."""
    dice = Dice(f"minkref disc sums {seed}:{number}")
    if number % 4 == 3:
        family = DISC_FAMILIES[sorted(DISC_FAMILIES)[number // 4 % len(DISC_FAMILIES)]]
        facts = DegenerateWithDisc.of(family, seed, number // 4 // len(DISC_FAMILIES)).facts
        P, square = facts.P, facts.squared_radius
    else:
        P = set_of(drawn_set(seed, number)[1])
        square = _radius(dice, P, number % 4 == 2)
    certificate = DiscSumCertificate(P, square)
    certificate.sum()
    for _ in range(3):
        x, y = (Fraction(dice.randint(-40, 400), 30) for _ in range(2))
        certificate.point((str(x), str(y)))
    return certificate


def _radius(dice: Dice, P: _core.PolygonSet, at_event: bool) -> Fraction:
    """A squared radius."""
    events = _core.diagram_events(P)
    squares = [row[1] for row in events.rows(0, len(events)) if row[1] is not None]
    if at_event and squares:
        return Fraction(dice.choice(squares))
    return Fraction(dice.randint(1, 60), dice.choice((4, 7, 16)))


def made(certificate: DiscSumCertificate) -> tuple[Value, Value]:
    """Certificate and case as JSON values."""
    return json.loads(certificate.text("case.json")), json.loads(certificate.case())


def is_true(certificate: Value, case: Value) -> bool:
    """Whether digest, holes and points are right, by the reference's other route and plain
    fractions."""
    P = _core.PolygonSet.from_json(json.dumps(case["P"]))
    again = DiscSumCertificate(P, Fraction(certificate["square"]))
    for claim in certificate["claims"]:
        if claim["claim"] == "sum":
            found = _core.offset(P, str(again.square), 1, "paper")
            true = digest(found.canonical_json()), found.holes
            if (claim["digest"], claim["holes"]) != true:
                return False
            continue
        x, y = claim["point"]
        again.point((str(x), str(y)))
        if again.claims[-1]["distance"] != claim["distance"]:
            return False
    return True


def false_certificates(certificate: Value, dice: Dice) -> Iterator[tuple[str, Value]]:
    """One of each kind, where the certificate has what it changes: none of them is true."""
    for name, change in KINDS.items():
        value = copy.deepcopy(certificate)
        if change(value, value["claims"][0], dice):
            yield name, value


def _joint_moved(_: Value, total: Value, dice: Dice) -> bool:
    """Along no edge, and on no circle about a vertex nearby."""
    if not total["joints"]:
        return False
    place, far = dice.choice(total["joints"]), Fraction(1, dice.choice((7, 10**9)))
    for k, way in ((2, far), (3, far * Fraction(355, 113))):
        place[k][0] = str(Fraction(place[k][0]) + way)
    return True


def _radius_changed(value: Value, _: Value, dice: Dice) -> bool:
    value["square"] = str(
        Fraction(value["square"]) * (1 + Fraction(1, dice.choice((2, 97, 10**9))))
    )
    return True


def _ring_dropped(_: Value, total: Value, dice: Dice) -> bool:
    component = dice.choice(total["components"])
    del component[dice.randrange(len(component))]
    return True


def _ring_repeated(_: Value, total: Value, dice: Dice) -> bool:
    component = dice.choice(total["components"])
    component.append(list(dice.choice(component)))
    return True


def _ring_reversed(_: Value, total: Value, dice: Dice) -> bool:
    ring = dice.choice(dice.choice(total["components"]))
    ring.reverse()
    return len(ring) > 2


def _pieces_swapped(_: Value, total: Value, dice: Dice) -> bool:
    ring = dice.choice(dice.choice(total["components"]))
    if len(ring) < 3:
        return False
    i, j = dice.sample(range(len(ring)), 2)
    ring[i], ring[j] = ring[j], ring[i]
    return True


def _hole_filled(_: Value, total: Value, dice: Dice) -> bool:
    holed = [component for component in total["components"] if len(component) > 1]
    if not holed:
        return False
    dice.choice(holed).pop()
    total["holes"] -= 1
    return True


def _hole_first(_: Value, total: Value, dice: Dice) -> bool:
    holed = [component for component in total["components"] if len(component) > 1]
    if not holed:
        return False
    dice.choice(holed).reverse()
    return True


def _holes_counted(_: Value, total: Value, dice: Dice) -> bool:
    total["holes"] += dice.choice((-1, 1, 2))
    return True


def _components_joined(_: Value, total: Value, dice: Dice) -> bool:
    components = total["components"]
    if len(components) < 2:
        return False
    last = components.pop()
    components[0] += last
    return True


def _component_split(_: Value, total: Value, dice: Dice) -> bool:
    holed = [component for component in total["components"] if len(component) > 1]
    if not holed:
        return False
    total["components"].append([dice.choice(holed).pop()])
    return True


def _digest_changed(_: Value, total: Value, dice: Dice) -> bool:
    k = dice.randrange(64)
    old = total["digest"]
    total["digest"] = old[:k] + f"{(int(old[k], 16) + dice.randint(1, 15)) % 16:x}" + old[k + 1 :]
    return True


def _parents_swapped(_: Value, total: Value, dice: Dice) -> bool:
    """The walk of a curve with a free part, and one without, or wholly free, change places."""
    walks = total[dice.choice(("edges", "arcs"))]
    pairs = [
        (i, j)
        for i, j in itertools.permutations(range(len(walks)), 2)
        if walks[i] == FREE and walks[j] != FREE
    ]
    if not pairs:
        return False
    i, j = dice.choice(pairs)
    walks[i], walks[j] = walks[j], walks[i]
    return True


def _link_changed(total: Value, dice: Dice, to_free: bool) -> bool:
    """A part that is blocked is free, or a free one is blocked."""
    places = [
        (walk, k)
        for walk in (*total["edges"], *total["arcs"])
        for k in range(1, len(walk), 2)
        if (walk[k] == "free") != to_free
    ]
    if not places:
        return False
    walk, k = dice.choice(places)
    walk[k] = "free" if to_free else dice.randrange(len(total["edges"]))
    return True


def _blocked_freed(_: Value, total: Value, dice: Dice) -> bool:
    return _link_changed(total, dice, True)


def _free_blocked(_: Value, total: Value, dice: Dice) -> bool:
    return _link_changed(total, dice, False)


def _curve_dropped(_: Value, total: Value, dice: Dice) -> bool:
    walks = total[dice.choice(("edges", "arcs"))]
    if not walks:
        return False
    del walks[dice.randrange(len(walks))]
    return True


def _point_misplaced(value: Value, _: Value, dice: Dice) -> bool:
    """Inside instead of outside, or far outside instead of anywhere near."""
    claim = dice.choice(value["claims"][1:])
    if dice.random() < 0.5 and claim["distance"] < 1:
        claim["point"][dice.randrange(2)] = str(10**6 + dice.randint(0, 10**6))
    else:
        claim["distance"] = dice.choice([d for d in (-1, 0, 1) if d != claim["distance"]])
    return True


#: What is changed: each makes a certificate false.
KINDS: dict[str, Callable[[Value, Value, Dice], bool]] = {
    "a joint moved": _joint_moved,
    "another radius": _radius_changed,
    "a ring dropped": _ring_dropped,
    "a ring repeated": _ring_repeated,
    "a ring reversed": _ring_reversed,
    "two pieces swapped": _pieces_swapped,
    "a hole filled": _hole_filled,
    "a hole as outer ring": _hole_first,
    "holes miscounted": _holes_counted,
    "components joined": _components_joined,
    "a component split": _component_split,
    "another digest": _digest_changed,
    "two curves swapped": _parents_swapped,
    "a blocked part freed": _blocked_freed,
    "a free part blocked": _free_blocked,
    "a curve dropped": _curve_dropped,
    "a point misplaced": _point_misplaced,
}
