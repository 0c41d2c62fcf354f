"""Valid scales of paths, traps, their certificates, and speed."""

from __future__ import annotations

import math
import random
import time
from collections import Counter
from fractions import Fraction
from typing import Any

import minkref
from minkref.certify.motion.path_certificate import THIN
from minkref.fuzz.cgal.oracle import CgalOracle
from minkref.fuzz.judges.motion.path_sums import PathBySums
from minkref.fuzz.judges.motion.path_traps import enclosing_ring, way_out
from minkref.fuzz.judges.motion.trap_cases import KINDS, trap_case
from minkref.fuzz.motion.path_cases import PathCase, path_case
from minkref.fuzz.motion.path_collisions import Collisions, by_slow_engine, by_triangles
from minkref.reports.evidence.certificates.path_cases import (
    Made,
    checking_seconds,
    faults,
    figures,
    joined,
    made,
)
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.2, 1.2, 10)
ALONE = True  # it measures time

SEED = 3100
METHOD = "reduced"
CASES = Counts(4, 60, 500)
SLOW = Counts(1, 25, 200)
TRAPS = Counts(1, 25, 200)
DOORS = Counts(8, 25, 200)
MOST_SECONDS = 30.0
HAIR = Fraction(1, 1 << 20)
CONTACTS = ("allowed", "forbidden")
SLOW_SCALES = 4
TARGET_SECONDS = 1.0
RUNS = 3  # the shortest counts
WIDTH = Counts(Fraction(1, 2), Fraction(1, 20), Fraction(1, 1000))  # width of the bracket by sums
ABOVE = Fraction(4)  # a scale that is too large
TARGET_RATIO = 10.0
WORDS = {"trapped": "claims of a ring", "escapes": "claims of a way out", "hit": "claims of a hit"}


def run(findings: Findings, size: Size) -> None:
    _cases(findings, size.of(CASES), size.of(SLOW))
    _traps(findings, size.of(TRAPS))
    _doors(findings, size.of(DOORS))
    _speed(findings, size.of(WIDTH))


def _cases(findings: Findings, count: int, slow: int) -> None:
    tally: Counter[str] = Counter()
    wrong: list[str] = []
    unproven: list[str] = []
    without: Counter[str] = Counter()
    proofs = []
    tasks = [(index, index < slow) for index in range(count)]
    for found in in_processes(judge, tasks, 50, "paths"):
        tally.update(found["tally"])
        wrong += found["faults"]
        unproven += found["unproven"]
        without.update(found["without"])
        proofs.append(found["proofs"])
    findings.none("random paths: answers that differ", wrong)
    findings.none("random paths: certificates that a checker does not verify", unproven)
    proven = sum(one["certificates"] for one in proofs)
    findings.equal(
        "random paths: answers with a certificate, or a part or obstacles that are a segment or a "
        "point and may touch", len(CONTACTS) * count, proven + without[THIN],
    )  # fmt: skip
    findings.equal("random paths", count, tally["cases"])
    findings.equal("of them before the slow engine", slow, tally["slow cases"])
    findings.note(
        f"{tally['cases']:,} random paths ({tally['degenerate']:,} degenerate, seed {SEED}), "
        f"contact allowed and forbidden: {tally['ranges']:,} ranges, {tally['single']:,} single "
        f"scales, {tally['bounds']:,} bounds; {tally['scales']:,} scales from the definition, "
        f"{tally['slow scales']:,} by the slow engine"
    )
    findings.figures["cases"] = dict(tally)
    _certified(findings, "paths", proofs, without)


def _certified(
    findings: Findings, what: str, several: list[dict[str, float]], without: Counter[str]
) -> None:
    """`several`: figures of certificates that both checkers verified; `without`: reasons for
    missing certificates."""
    total = several[0]
    for one in several[1:]:
        total = joined(total, one)
    told = "; ".join(f"{count} without: {why}" for why, count in sorted(without.items()))
    findings.note(
        f"certificates of {what}, of all their scales, verified by both checkers: "
        f"{total['certificates']:,}, the largest {total['largest bytes']:,} bytes, the slowest "
        f"made in {total['longest to make, s']:.2f} s" + (f"; {told}" if told else "")
    )
    findings.figures[f"certificates of {what}"] = {**total, "without": dict(without)}


def judge(task: tuple[int, bool]) -> dict[str, Any]:
    """One case, with contact allowed and forbidden."""
    index, slowly = task
    case = path_case(SEED, index)
    tally: Counter[str] = Counter(cases=1)
    tally["degenerate"] += case.kind != "general"
    tally["slow cases"] += slowly
    wrong = []
    certificates = []
    for contact in CONTACTS:
        certificates.append(_path_proof(case, contact))
        found = minkref.valid_scales(case.part, case.obstacles, case.path, contact)
        for route in ("contacts", "index"):
            other = minkref.valid_scales(case.part, case.obstacles, case.path, contact, route=route)
            if other.ranges != found.ranges:
                wrong.append(f"{case.name} ({case.kind}), {contact}: {route} differs")
        tally["ranges"] += len(found.ranges)
        tally["single"] += sum(one.low == one.high for one in found.ranges)
        tally["bounds"] += len(found.bounds)
        wrong += _scales(case, contact, found, slowly, tally)
    return {"tally": tally, "faults": wrong, **_proofs(certificates)}


def _path_proof(case: PathCase, contact: str) -> Made:
    sets = case.part, case.obstacles
    return made(f"{case.name}, {contact}", sets, case.path, lambda proof: proof.valid(contact))


def _proofs(several: list[Made]) -> dict[str, Any]:
    """Runs both checkers on the existing certificates."""
    there = [one for one in several if one.certificate is not None]
    without = Counter(one.why for one in several if one.certificate is None)
    return {"unproven": faults(there), "without": without, "proofs": figures(there)}


def _scales(
    case: PathCase, contact: str, found: minkref.ValidScales, slowly: bool, tally: Counter[str]
) -> list[str]:
    """Single scales from the definition."""
    scales = {Fraction(1, 50), Fraction(1), Fraction(50)}
    for bound in found.bounds:
        scales |= {bound.scale, bound.scale * (1 - HAIR), bound.scale * (1 + HAIR)}
    for one in found.ranges:
        scales.add((one.low + one.high) / 2 if one.high is not None else 2 * one.low + 1)
    collisions = Collisions(case.part, case.obstacles, case.path)
    triangles = by_triangles(case.part, case.obstacles)
    wrong = []
    for scale in sorted(scales):
        tally["scales"] += 1
        if collisions.collides(scale, contact, triangles) == (scale in found):
            wrong.append(f"{case.name} ({case.kind}), {contact}: wrong at {scale}")
    if slowly:
        dice = random.Random(case.name)
        engine = by_slow_engine(case.part, case.obstacles)
        for scale in dice.sample(sorted(scales), min(SLOW_SCALES, len(scales))):
            tally["slow scales"] += 1
            if collisions.collides(scale, contact, engine) == (scale in found):
                wrong.append(f"{case.name}, {contact}: the slow engine differs at {scale}")
    return wrong


def _traps(findings: Findings, count: int) -> None:
    tally: Counter[str] = Counter()
    wrong: list[str] = []
    unproven: list[str] = []
    without: Counter[str] = Counter()
    proofs = []
    for found in in_processes(judge_trap, range(count), 50, "traps"):
        tally.update(found["tally"])
        wrong += found["faults"]
        unproven += found["unproven"]
        without.update(found["without"])
        proofs.append(found["proofs"])
    findings.none("traps: answers without a ring or a way out", wrong)
    findings.none("traps: certificates that a checker does not verify", unproven)
    proven = sum(one["certificates"] for one in proofs)
    findings.equal("traps: answers with a certificate", len(CONTACTS) * count, proven)
    findings.law("traps with a ring", tally["rings"] >= count, count, tally["rings"])
    findings.note(
        f"{count:,} places in assemblies: {tally['rings']:,} scales of traps with an enclosing "
        f"ring, {tally['ways']:,} other free scales with a way out"
    )
    findings.note(
        f"the certificates of traps have {tally['claims of a ring']:,} rings, "
        f"{tally['claims of a way out']:,} ways out and {tally['claims of a hit']:,} hits at the "
        f"place, each for a range of scales or one; together they tell of all scales"
    )
    findings.figures["traps"] = dict(tally)
    _certified(findings, "traps", proofs, without)


def judge_trap(index: int) -> dict[str, Any]:
    """Judges a place in a room with a door of random width."""
    dice = random.Random(f"{SEED}:trap:{index}")
    part, obstacles, at = trap_in_room(dice)
    found = minkref.trapped_scales(part, obstacles, at)
    free = minkref.valid_scales(part, obstacles, [at])
    tally: Counter[str] = Counter(cases=1)
    wrong = []
    scales = set()
    for end in (*(bound.scale for bound in found.bounds), *(bound.scale for bound in free.bounds)):
        scales |= {end * (1 - HAIR), end, end * (1 + HAIR)}
    for one in (*found.ranges, *free.ranges):
        scales.add((one.low + one.high) / 2 if one.high is not None else 2 * one.low + 1)
    for scale in sorted(scales):
        if scale not in free:
            if scale in found:
                wrong.append(f"trap {index}: trapped at {scale}, where the place is not free")
            continue
        if scale in found:
            at_bound = any(bound.scale == scale for bound in free.bounds)
            ring = None if at_bound else enclosing_ring(part, obstacles, at, scale)
            tally["rings"] += ring is not None
            if ring is None and not at_bound:
                wrong.append(f"trap {index}: no ring at {scale}")
        else:
            way = way_out(part, obstacles, at, scale)
            tally["ways"] += way is not None
            if way is None:
                wrong.append(f"trap {index}: no way out at {scale}")
    certificates = [_trap_proof(index, part, obstacles, at, contact) for contact in CONTACTS]
    for proof in certificates:
        for claim in proof.certificate.claims if proof.certificate is not None else ():
            tally[WORDS.get(claim["claim"], "claims of an answer")] += 1
    return {"tally": tally, "faults": wrong, **_proofs(certificates)}


def _doors(findings: Findings, count: int) -> None:
    """Doors that just shut, contact forbidden: the commonest trap."""
    tally: Counter[str] = Counter()
    kinds: Counter[str] = Counter()
    unproven: list[str] = []
    slow: list[str] = []
    proofs = []
    without: Counter[str] = Counter()
    for found in in_processes(judge_door, range(count), 50, "doors"):
        tally.update(found["tally"])
        kinds.update([found["kind"]])
        unproven += found["unproven"]
        slow += found["slow"]
        without.update(found["without"])
        proofs.append(found["proofs"])
    findings.none("doors that shut: certificates that a checker does not verify", unproven)
    findings.none(
        f"doors that shut: answers neither certified nor refused in {MOST_SECONDS:g} s", slow
    )
    findings.equal("doors that shut: kinds that are drawn", set(KINDS), set(kinds))
    findings.law(
        "doors that shut: certificates with ways that move", tally["moving"] >= count / 4,
        f"at least {count / 4:g}", tally["moving"],
    )  # fmt: skip
    findings.figures["doors that shut"] = {**tally, "kinds": dict(kinds)}
    _certified(findings, "traps whose doors shut", proofs, without)


def judge_door(index: int) -> dict[str, Any]:
    case = trap_case(SEED, index)
    sets = case.part, case.obstacles
    one = made(case.name, sets, [case.at], lambda proof: proof.trap("forbidden"))
    steps = [] if one.certificate is None else one.certificate.steps
    moves = any(len(place) == 4 for step in steps for place in step.get("path") or ())
    tally = Counter(cases=1, moving=int(moves), refused=int(one.certificate is None))
    slow = [f"{case.name} ({case.kind}): {one.seconds:.0f} s"] * (one.seconds > MOST_SECONDS)
    return {"tally": tally, "kind": case.kind, "slow": slow, **_proofs([one])}


def _trap_proof(index: int, part: Any, obstacles: Any, at: Any, contact: str) -> Made:
    name = f"trap {index}, {contact}"
    return made(name, (part, obstacles), [at], lambda proof: proof.trap(contact))


def trap_in_room(dice: random.Random) -> tuple[minkref.PolygonSet, minkref.PolygonSet, Any]:
    """Draws a part, a room with a door of random width, and a place in the room."""
    low, high = sorted(dice.sample(range(1, 12), 2))
    bend = dice.randint(0, 2)
    room = minkref.PolygonSet(
        [
            (-2, -2), (14, -2), (14, low - bend), (12, low), (12, 0), (0, 0), (0, 12), (12, 12),
            (12, high), (14, high), (14, 14), (-2, 14),
        ]
    )  # fmt: skip
    corners = dice.randint(3, 7)
    turn = dice.random()
    ring: list[tuple[int, int]] = []
    for k in range(corners):
        angle = 2 * math.pi * (k + turn) / corners
        point = round(9 * math.cos(angle)), round(9 * math.sin(angle))
        if point not in ring:
            ring.append(point)
    part = minkref.PolygonSet(ring).scaled("1/9")
    return part, room, (Fraction(dice.randint(8, 16), 2), Fraction(dice.randint(8, 16), 2))


def _speed(findings: Findings, width: Fraction) -> None:
    """Times a star-like part with 100 vertices on a path with 100 segments, between rows of
    pillars."""
    part, obstacles, path = large_path()
    every = []
    for _ in range(RUNS):
        began = time.perf_counter()
        found = minkref.valid_scales(part, obstacles, path)
        every.append(time.perf_counter() - began)
    seconds = min(every)
    findings.target(
        "a path of 100 segments, obstacles of 1,000 vertices, a part of 100, on one core",
        seconds < TARGET_SECONDS, f"below {TARGET_SECONDS:g} s", f"{seconds:.2f} s",
    )  # fmt: skip
    findings.note(
        f"{found.statistics['triples']:,} triples, {found.statistics['exact_triples']:,} of them "
        f"exact; valid: {', '.join(map(str, found.ranges))}"
    )
    findings.figures["speed"] = {"seconds": seconds, **found.statistics}
    proof = made("the large path", (part, obstacles), path, lambda one: one.valid())
    findings.none("the large path: checkers that do not verify its certificate", faults([proof]))
    told = {**figures([proof]), **checking_seconds(proof)}
    findings.note(
        f"the certificate of that path: {told['largest bytes']:,} bytes, made in "
        f"{told['longest to make, s']:.2f} s, checked in {told['check.py, s']:.2f} s (check.py) "
        f"and {told['minkref-check, s']:.2f} s (minkref-check)"
    )
    findings.figures["certificate of the large path"] = told
    _beside_sums(findings, found, seconds, width)


def _beside_sums(
    findings: Findings, found: minkref.ValidScales, seconds: float, width: Fraction
) -> None:
    """The same bound by CGAL's sums at single scales, and a bisection."""
    part, obstacles, path = large_path()
    oracle = CgalOracle(METHOD)
    judge = PathBySums(part, obstacles, [(Fraction(x), Fraction(y)) for x, y in path], oracle)
    began = time.perf_counter()
    try:
        low, high = judge.bracket(Fraction(0), ABOVE, width)
    finally:
        oracle.close()
    whole = time.perf_counter() - began
    bound = found.largest
    findings.law(
        f"CGAL's sums bracket the bound to {width}",
        bound is not None and low <= bound <= high, f"{bound}", f"{low} to {high}",
    )  # fmt: skip
    ratio = judge.cgal_seconds / seconds
    if width == WIDTH.full:
        findings.target(
            f"seconds of CGAL's sums for a bound to {width} over those of the exact bound",
            ratio > TARGET_RATIO, f"above {TARGET_RATIO:g}", f"{ratio:.0f}",
        )  # fmt: skip
    findings.note(
        f"the exact bound: {seconds:.2f} s; to {width} by {judge.sums:,} sums of CGAL at "
        f"{judge.scales} scales: {judge.cgal_seconds:.1f} s in CGAL's function, "
        f"{judge.cgal_seconds / judge.scales:.2f} s for each scale; {whole:.1f} s with processes, "
        f"texts and the path held against the sums ({judge.path_seconds:.1f} s). A bisection is "
        f"right for a star-shaped part only; of others each of {ABOVE / width} steps up to "
        f"{ABOVE} would have to be looked at"
    )
    findings.figures["by sums of CGAL"] = {
        "width": str(width), "low": str(low), "high": str(high), "sums": judge.sums,
        "scales": judge.scales, "cgal seconds": judge.cgal_seconds, "all seconds": whole,
        "path seconds": judge.path_seconds, "ratio": ratio,
    }  # fmt: skip


def large_path() -> tuple[minkref.PolygonSet, minkref.PolygonSet, list[tuple[int, int]]]:
    dice = random.Random(SEED)
    ring = []
    for k in range(100):
        angle, radius = 2 * math.pi * k / 100, dice.randint(60, 100) * 1000
        ring.append((round(radius * math.cos(angle)), round(radius * math.sin(angle))))
    part = minkref.PolygonSet(ring).scaled("1/100000")
    pillars: list[Any] = []
    for row in range(10):
        for column in range(10):
            outline = [
                (
                    round(10000 * (10 * column + 3 * math.cos(2 * math.pi * k / 10))),
                    round(10000 * (10 * row + 3 * math.sin(2 * math.pi * k / 10))),
                )
                for k in range(10)
            ]
            pillars.append([outline])
    obstacles = minkref.PolygonSet(pillars).scaled("1/10000")
    path = [(5, -8)]
    for k in range(100):  # row by row, between the pillars
        row, step = divmod(k, 10)
        x = 10 * step + 5 if row % 2 == 0 else 95 - 10 * step
        path.append((x, 10 * row + 5 + (step % 3 - 1 if 0 < step < 9 else 0)))
    return part, obstacles, path
