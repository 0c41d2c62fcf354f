"""Writes the seeds of the targets on the reference: small pairs of every family, at scales of
events and elsewhere. seeds.py [FOLDER]"""

from __future__ import annotations

import json
import sys
from pathlib import Path

from minkref.fuzz.plane.families.catalogue import FAMILIES
from minkref.fuzz.plane.families.probes import scale_probes

FOLDER = Path(__file__).resolve().parents[1] / "corpus" / "pair"
SEED = 2012
EACH, LOOKED_AT = 6, 300
MOST_VERTICES = 16  # of an operand


def vertices(operand: dict) -> int:
    return sum(
        len(ring)
        for polygon in operand["polygons"]
        for ring in (polygon["outer"], *polygon["holes"])
    )


def scales(P: str, Q: str, scale: str, index: int) -> dict:
    """The pair's own scale, an event's scale, or the interval between two events."""
    probes = [s for position, s in scale_probes(P, Q, 16) if position == "at"]
    if index % 3 == 1 and probes:
        return {"scales": [probes[len(probes) // 2]]}
    if index % 3 == 2 and len(probes) > 1:
        return {"interval": {"from": probes[0], "to": probes[-1]}}
    return {"scales": [scale]}


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for family in FAMILIES.values():
        pairs = [(index, family.pair(SEED, index)) for index in range(LOOKED_AT)]
        small = [
            (index, P, Q, pair)
            for index, pair in pairs
            for P, Q in [(json.loads(pair.P), json.loads(pair.Q))]
            if max(vertices(P), vertices(Q)) <= MOST_VERTICES
        ]
        small.sort(key=lambda row: vertices(row[1]) + vertices(row[2]))
        step = max(1, len(small) // EACH)
        for kept, (index, P, Q, pair) in enumerate(small[::step][:EACH]):
            name = f"{family.name}-{index}"
            case = {"schema": "case-v1", "id": name, "dimension": 2, "P": P, "Q": Q}
            case |= scales(pair.P, pair.Q, pair.scale, kept)
            text = json.dumps(case, separators=(",", ":"))
            (folder / f"{name}.json").write_text(text + "\n", encoding="utf-8")
        print(f"{family.name}: {min(EACH, len(small))}")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if sys.argv[1:] else FOLDER)
