"""The producer of path, escape and trap certificates (docs/certificates-paths.md). The producer is
not trusted: the checker is."""

from __future__ import annotations

import json
from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any, TypeVar

from minkref import _core
from minkref.argument_types import expect_sets, number
from minkref.certify.case_text import plain_polygons
from minkref.certify.claims_text import shown
from minkref.certify.motion.clearance import Clearance, Collision, TooLong
from minkref.certify.motion.collisions import Collisions, NoHit
from minkref.certify.motion.convex_cells import Place
from minkref.certify.motion.moving_parts import MovingPlace, MovingWay, Pair, Way, stays
from minkref.certify.motion.scale_cells import document, is_within
from minkref.certify.motion.trap_cover import TrapCover
from minkref.certify.plane.certificate import NoProof
from minkref.certify.plane.piece_nodes import Vector
from minkref.errors import Refusal
from minkref.exact import digest
from minkref.motion.path_values import trapped_scales, valid_scales
from minkref.motion.scale_ranges import ScaleRange, ranges_of
from minkref.version import version

PIECES = [0, 1]  # the numbers of their steps
Number = str | int | Fraction
THIN = (
    "with contact allowed a point or a segment may pass along the seam of two pieces: there are "
    "certificates of it with contact forbidden only"
)


class PathCertificate:
    """Steps and claims about a part R, scaled, that moves among obstacles O along a path, or from a
    place (a path with one vertex). Each method adds a claim with its proof, and returns the claim's
    number. Exact. Raises NoProof if a claim does not hold, or has no certificate: with contact
    allowed neither R nor O may be a point or a segment."""

    def __init__(
        self, part: _core.PolygonSet, obstacles: _core.PolygonSet, path: Sequence[Sequence[Number]]
    ) -> None:
        """Validates both sets; raises BadInput for an invalid set."""
        expect_sets(part=part, obstacles=obstacles)
        part.validate("part")
        obstacles.validate("obstacles")
        self.R, self.O = part, obstacles
        self.path: list[Place] = [
            (Fraction(number("x", x)), Fraction(number("y", y))) for x, y in path
        ]
        if not self.path:
            raise Refusal("a path has at least one vertex", "path", "give it one", "bad-path")
        self.pair = Pair(part, obstacles)
        self.steps: list[Any] = [*self.pair.steps]
        self.claims: list[dict[str, Any]] = []

    def __repr__(self) -> str:
        return shown(self, self.claims)

    def free(self, scales: ScaleRange, contact: str = "allowed") -> int:
        """Claims that the path collides nowhere at any scale of a range."""
        step = self._clear([*map(stays, self.path)], scales, contact, None)
        return self._claim("free", contact, scales, step=step)

    def hit(self, scales: ScaleRange, contact: str = "allowed") -> int:
        """Claims that the path collides somewhere at each scale of a range."""
        self._refuse_thin(contact)
        ways = [Way(self.pair, start, end) for start, end in _segments(self.path)]
        collisions = Collisions(self.pair, ways, contact == "allowed")
        try:
            hits = collisions.hits(scales)
        except NoHit as error:
            raise NoProof(str(error)) from error
        return self._claim("hit", contact, scales, by=PIECES, hits=hits)

    def valid(
        self,
        contact: str = "allowed",
        from_scale: Number | None = None,
        to_scale: Number | None = None,
        ranges: Sequence[ScaleRange] | None = None,
    ) -> int:
        """Claims the valid scales of a window: the path is free at all of them, and has a hit at
        all others. `ranges`: an answer to use instead of the reference's."""
        window = _window(from_scale, to_scale)
        if ranges is None:
            low = None if from_scale is None else window.low
            ranges = valid_scales(self.R, self.O, self.path, contact, low, window.high).ranges
        parts = ranges_of(window, ranges)
        claims = [
            (self.free if is_valid else self.hit)(scales, contact) for scales, is_valid in parts
        ]
        valid = [document(one) for one in ranges]
        return self._claim("valid", contact, window, valid=valid, claims=claims)

    def escapes(
        self,
        scales: ScaleRange,
        way: Sequence[MovingPlace],
        normal: Vector,
        contact: str = "allowed",
    ) -> int:
        """Claims that at each scale of a range a way leads from the place to another, from which
        the part may go on along a normal for ever. Places of the way may move with the scale."""
        step = self._clear(way, scales, contact, [*map(_told, way)])
        return self._claim("escapes", contact, scales, step=step, normal=list(normal))

    def trapped(self, scales: ScaleRange, ring: dict[str, Any], contact: str = "allowed") -> int:
        """Claims that at each scale of a range the place is free, and a ring of places that collide
        leads around it (certify/motion/rings.py)."""
        step = self._clear([*map(stays, self.path)], scales, contact, None)
        return self._claim("trapped", contact, scales, step=step, by=PIECES, **ring)

    def trap(
        self,
        contact: str = "allowed",
        from_scale: Number | None = None,
        to_scale: Number | None = None,
        ranges: Sequence[ScaleRange] | None = None,
    ) -> int:
        """Claims the scales of a window at which the part is trapped at the place: rings lead
        around the place there; elsewhere the part escapes, or collides at the place. `ranges`: as
        above. Raises NoProof if rings or ways out are missing at some scale
        (certify/motion/trap_cover.py)."""
        self._refuse_thin(contact)
        place = self._place()
        window = _window(from_scale, to_scale)
        bounds = (None if from_scale is None else window.low), window.high
        if ranges is None:
            ranges = trapped_scales(self.R, self.O, place, contact, *bounds).ranges
        free = valid_scales(self.R, self.O, [place], contact, *bounds)
        cover = TrapCover(self.pair, (self.R, self.O), place, contact)
        claims: list[int] = []
        for part, is_free in ranges_of(window, free.ranges):
            if not is_free:
                claims.append(self.hit(part, contact))
                continue
            held = [one for one in ranges if is_within(one, part)]
            for scales, is_trapped in ranges_of(part, held):
                if is_trapped:
                    claims += [self.trapped(*one, contact) for one in cover.rings(scales)]
                else:
                    claims += [self.escapes(*one, contact) for one in cover.ways(scales)]
        told = [document(one) for one in ranges]
        return self._claim("trap", contact, window, trapped=told, claims=claims)

    def _place(self) -> Place:
        if len(self.path) != 1:
            what = "a trap is about a place, and the path has more vertices"
            raise Refusal(what, "path", "give one vertex", "bad-path")
        return self.path[0]

    def text(self, case: str, title: str = "", producer: str = "") -> str:
        """The certificate; `case`: the path to the case, relative to the certificate."""
        head = {
            "certificate": "path-certificate-v1",
            "title": title,
            "producer": producer or f"minkref {version()}",
            "case": {"path": case, "sha256": self.case_digest()},
        }
        told = {name: value for name, value in head.items() if value}
        parts = [f'"{name}":{json.dumps(told[name], ensure_ascii=False)}' for name in told]
        parts.append(f'"steps":[{",".join(map(_compact, self.steps))}]')
        parts.append(f'"claims":[{",".join(map(_compact, self.claims))}]')
        return "{" + ",\n".join(parts) + "}\n"

    def case_digest(self) -> str:
        """The digest of both sets and the path, as the certificate names its case."""
        value = {"O": plain_polygons(self.O), "R": plain_polygons(self.R), "path": self._plain()}
        return digest(json.dumps(value, sort_keys=True, separators=(",", ":")))

    def case(self) -> str:
        """The text of the certified case."""
        head = f'"schema":"path-case-v1","id":"{self.case_digest()[:12]}"'
        sets = f'"R":{self.R.to_json()},\n"O":{self.O.to_json()}'
        return f'{{{head},\n{sets},\n"path":{_compact(self._plain())}}}\n'

    def _plain(self) -> list[list[str]]:
        return [[str(x), str(y)] for x, y in self.path]

    def _clear(
        self,
        path: Sequence[MovingPlace],
        scales: ScaleRange,
        contact: str,
        told: list[list[str]] | None,
    ) -> int:
        """Adds a step and returns its number; `told`: the path to write, None for the case's
        path."""
        self._refuse_thin(contact)
        clearance = Clearance(self.pair, scales, contact)
        codes = []
        for k, (start, end) in enumerate(_segments(path)):
            try:
                codes.append(clearance.code(MovingWay(self.pair, start, end, scales)))
            except Collision as error:
                raise NoProof(f"segment {k} collides at a scale of {scales}") from error
            except TooLong as error:
                raise NoProof(f"the proof of segment {k} has too many entries") from error
        self.steps.append(
            {
                "rule": "clear",
                "by": PIECES,
                "contact": contact,
                "path": told,
                "scales": document(scales),
                "normals": clearance.normals,
                "codes": codes,
            }
        )
        return len(self.steps) - 1

    def _refuse_thin(self, contact: str) -> None:
        if contact == "allowed" and not all(o.is_region or o.is_empty for o in (self.R, self.O)):
            raise NoProof(THIN)

    def _claim(self, claim: str, contact: str, scales: ScaleRange, **members: Any) -> int:
        told = {"claim": claim, "contact": contact, "scales": document(scales), **members}
        self.claims.append(told)
        return len(self.claims) - 1


Kind = TypeVar("Kind")


def _segments(path: Sequence[Kind]) -> list[tuple[Kind, Kind]]:
    """Segments from each place to the next; a single place gives a segment to itself."""
    return list(pairwise(path)) or [(path[0], path[0])]


def _told(place: MovingPlace) -> list[str]:
    """Coordinates as certificates write them: only two numbers for a place that stays."""
    return [str(c) for c in (place if any(place[1::2]) else place[::2])]


def _window(from_scale: Number | None, to_scale: Number | None) -> ScaleRange:
    low = None if from_scale is None else Fraction(number("from_scale", from_scale))
    high = None if to_scale is None else Fraction(number("to_scale", to_scale))
    return ScaleRange(low or Fraction(0), high, low is not None, high is not None)


def _compact(value: Any) -> str:
    return json.dumps(value, separators=(",", ":"))
