"""Where and what the events of a disc are, by a judge that shares nothing with the reference."""

from __future__ import annotations

import random
import time
from collections import Counter
from copy import deepcopy
from typing import Any

from minkref import _core
from minkref.degeneracies.catalogue import DISC_FAMILIES
from minkref.degeneracies.disc.generate import drawn_with_disc
from minkref.fuzz.families.drawing import shape_text
from minkref.fuzz.judges.disc_places import Table, compare, faults_of, rows_of
from minkref.fuzz.judges.place_draws import KINDS, drawn_set, set_of
from minkref.fuzz.judges.place_mutants import MUTANTS
from minkref.reports.evidence.framework.command import minkref
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import COMPARISON, REFERENCE, Findings

SUBJECT = (
    "Events of a disc before a judge of exact numbers: the place that the features of each single "
    "out, all that is as near, its kind; where each hole is born and which it leaves, where it "
    "ends, where components join, by bridges between nearest points and the chambers that they "
    "cut. About half of the sets have several changes at one radius, almost all several events; "
    "the same sets written otherwise, mirrored, turned and grown; and answers with one thing "
    "wrong, each kind of which is found."
)
MINUTES = (8, 0.3)
DEPENDS = (*REFERENCE, *COMPARISON, "oracle/places/*.py", "commands/disc/*.py",
           "degeneracies/disc/*.py")  # fmt: skip

SEED = 2046
SETS, QUICK_SETS, BATCH = 2000, 30, 10
FAMILIES = ("disc-doors", "disc-edges-on-one-line")
MEMBERS, QUICK_MEMBERS = 40, 2  # of each
LISTED, QUICK_LISTED = 40, 2  # sets of which the command's own lists are read, and the page's data
MUTATED, QUICK_MUTATED = 10, 1  # answers that each mutant changes
WITHIN = 60.0  # seconds


def batch(first: int) -> Table:
    table = Table()
    compare(SEED, range(first, first + BATCH), table)
    return table


def run(findings: Findings, quick: bool) -> None:
    count = QUICK_SETS if quick else SETS
    table = Table()
    for one in in_processes(batch, range(0, count, BATCH), each=20):
        table.add(one)
    findings.none("places, kinds, features or changes that the judge does not find", table.faults)
    counts = table.counts
    several = counts["sets with several changes at one radius"]
    findings.law(
        "sets with several changes at one radius", several * 5 > count * 2, "two fifths", several
    )
    tied = counts["sets with several events at one radius"]
    findings.law("sets with several events at one radius", tied * 2 > count, "half", tied)
    births = counts["sets with several births at one radius"]
    findings.law(
        "sets with several holes born at one radius", births * 9 > count, "a ninth", births
    )
    drawn = min(counts[f"sets: {kind}"] for kind in KINDS)
    findings.law("sets of each kind", drawn >= count // len(KINDS), count // len(KINDS), drawn)
    members = QUICK_MEMBERS if quick else MEMBERS
    findings.none(f"members of {' and '.join(FAMILIES)} with faults", _members(members))
    findings.none("lists of the command that are other ones", _listed(count, quick))
    mutants = _mutants(findings, QUICK_MUTATED if quick else MUTATED)
    findings.note(
        f"seed {SEED}: {counts['sets']:,} sets, {counts['events']:,} events; {counts['born']:,} "
        f"births, {counts['ended']:,} ends, {counts['joined']:,} joins; several events at one "
        f"radius in {counts['sets with several events at one radius']:,} sets, several changes in "
        f"{several:,}, several births in {births:,}"
    )
    findings.figures = {"counts": dict(counts), "mutants": mutants}


def _members(count: int) -> list[str]:
    """Of the families that are made to show what may go wrong."""
    faults = []
    for name in FAMILIES:
        for index in range(count):
            facts = drawn_with_disc(DISC_FAMILIES[name], SEED, index)
            found = faults_of(facts.shape, rows_of(facts.P))
            faults += [f"{name} {SEED}:{index}: {fault}" for fault in found]
    return faults


def _listed(count: int, quick: bool) -> list[str]:
    """`minkref events`, its list as JSON, against what was judged; and the names that the page
    has."""
    faults = []
    every = count // (QUICK_LISTED if quick else LISTED)
    for number in range(0, count, every):
        name, shape = drawn_set(SEED, number)
        wanted = rows_of(set_of(shape))
        for kind, rows in zip(("boundary", "topology"), wanted, strict=True):
            _, value = minkref("events", shape_text(shape), "disc", "--kind", kind)
            found = deepcopy(value["events"])
            for row in found:
                row["changes"] = row["changes"] if kind == "topology" else None
                if row["changes"] is None:
                    del row["changes"]
            if found != rows:
                faults.append(f"{name}: {kind}")
        drawing = _core.disc_index(set_of(shape)).drawing()
        for near, row in zip(drawing["near"], wanted[0], strict=True):
            edges = [drawing["features"][k][2:4] for k in near if len(drawing["features"][k]) > 2]
            if [list(edge) for edge in edges] != [
                e["edge"] for e in row["features"] if "edge" in e
            ]:
                faults.append(f"{name}: names of the page at {row['place']}")
    return faults


def _mutants(findings: Findings, wanted: int) -> dict[str, Any]:
    """How many changed answers of each kind the judge refuses, and how soon the first."""
    rows = {}
    for name, mutant in MUTANTS.items():
        dice = random.Random(f"minkref place mutant {name}")
        tried: Counter[bool] = Counter()
        first, number, begun = None, 0, time.monotonic()
        while sum(tried.values()) < wanted:
            _, shape = drawn_set(SEED + 1, number)
            number += 1
            changed = mutant(dice, shape, rows_of(set_of(shape)))
            if changed is None:
                continue
            is_found = bool(faults_of(shape, changed))
            tried[is_found] += 1
            if is_found and first is None:
                first = time.monotonic() - begun
        rows[name] = {"tried": wanted, "found": tried[True], "first found after": first}
        findings.law(f"{name.replace('_', ' ')}: found within {WITHIN:.0f} s",
                     first is not None and first <= WITHIN, f"{WITHIN:.0f} s",
                     "never" if first is None else f"{first:.1f} s")  # fmt: skip
    return rows
