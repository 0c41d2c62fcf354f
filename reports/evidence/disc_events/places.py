"""Places and kinds of disc events, from a judge that shares nothing with the reference."""

from __future__ import annotations

import random
import time
from collections import Counter
from copy import deepcopy
from typing import Any

from minkref import _core
from minkref.degeneracies.catalogue import DISC_FAMILIES
from minkref.fuzz.features.place_draws import KINDS, drawn_set, set_of
from minkref.fuzz.judges.disc.disc_places import Table, compare, faults_of, rows_of
from minkref.fuzz.judges.disc.place_mutants import MUTANTS
from minkref.fuzz.plane.families.drawing import shape_text
from minkref.reports.evidence.framework.command import minkref
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.1, 0.8, 8)

SEED = 2046
SETS, BATCH = Counts(20, 200, 2000), 10
FAMILIES = ("disc-doors", "disc-edges-on-one-line")
MEMBERS = Counts(1, 5, 40)  # of each
LISTED = Counts(1, 5, 40)  # sets with checked command lists and page data
MUTATED = Counts(1, 3, 10)  # answers that each mutant changes
WITHIN = 60.0  # seconds


def batch(first: int) -> Table:
    table = Table()
    compare(SEED, range(first, first + BATCH), table)
    return table


def run(findings: Findings, size: Size) -> None:
    count = size.of(SETS)
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
    members = size.of(MEMBERS)
    findings.none(f"members of {' and '.join(FAMILIES)} with faults", _members(members))
    findings.none("lists of the command that are other ones", _listed(count, size.of(LISTED)))
    mutants = _mutants(findings, size.of(MUTATED))
    findings.note(
        f"seed {SEED}: {counts['sets']:,} sets, {counts['events']:,} events; {counts['born']:,} "
        f"births, {counts['ended']:,} ends, {counts['joined']:,} joins; several events at one "
        f"radius in {counts['sets with several events at one radius']:,} sets, several changes in "
        f"{several:,}, several births in {births:,}"
    )
    findings.figures = {"counts": dict(counts), "mutants": mutants}


def _members(count: int) -> list[str]:
    """Faults in members of families made to show likely mistakes."""
    faults = []
    for name in FAMILIES:
        for index in range(count):
            facts, _ = DISC_FAMILIES[name].member(SEED, index)
            found = faults_of(facts.shape, rows_of(facts.P))
            faults += [f"{name} {SEED}:{index}: {fault}" for fault in found]
    return faults


def _listed(count: int, wanted: int) -> list[str]:
    """Compares the JSON list of `minkref events` with the judged rows, and checks the page's
    names."""
    faults = []
    every = count // wanted
    for number in range(0, count, every):
        name, shape = drawn_set(SEED, number)
        expected = rows_of(set_of(shape))
        for kind, rows in zip(("boundary", "topology"), expected, strict=True):
            _, value = minkref("events", shape_text(shape), "disc", "--kind", kind)
            found = deepcopy(value["events"])
            for row in found:
                row["changes"] = row["changes"] if kind == "topology" else None
                if row["changes"] is None:
                    del row["changes"]
            if found != rows:
                faults.append(f"{name}: {kind}")
        drawing = _core.disc_index(set_of(shape)).drawing()
        for near, row in zip(drawing["near"], expected[0], strict=True):
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
        first, number, begun = None, 0, time.process_time()
        while sum(tried.values()) < wanted:
            _, shape = drawn_set(SEED + 1, number)
            number += 1
            changed = mutant(dice, shape, rows_of(set_of(shape)))
            if changed is None:
                continue
            is_found = bool(faults_of(shape, changed))
            tried[is_found] += 1
            if is_found and first is None:
                first = time.process_time() - begun
        rows[name] = {"tried": wanted, "found": tried[True], "first found after": first}
        findings.law(f"{name.replace('_', ' ')}: found within {WITHIN:.0f} s",
                     first is not None and first <= WITHIN, f"{WITHIN:.0f} s",
                     "never" if first is None else f"{first:.1f} s")  # fmt: skip
    return rows
