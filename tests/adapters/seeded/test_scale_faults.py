"""The faults about the scale, which need P, Q, the scale and sP, and their adapter program."""

from __future__ import annotations

import json
import subprocess
import sys
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from faults_of_scale import ScaledSum, scaled
from plain_sum import Set
from seeded_adapter import made
from seeded_sums import FAULTS

# The hole of the sum dies at 541/186.
P: Set = {"polygons": [{"outer": [["-3", "-2"], ["4", "-1"], ["1", "3"]], "holes": []}]}
Q: Set = {
    "polygons": [
        {
            "outer": [["-40", "-40"], ["40", "-40"], ["40", "40"], ["-40", "40"]],
            "holes": [[["0", "20"], ["17", "-11"], ["-19", "-9"]]],
        }
    ]
}
OTHER_Q: Set = {"polygons": [{"outer": [["1", "0"], ["2", "0"], ["1", "1"]], "holes": []}]}
STEPS = (
    ("load", Q, ""),
    ("at", Q, "1"),
    ("at", Q, "1/3"),
    ("at", Q, "1/2"),
    ("update", Q, "3"),
    ("update", Q, "2"),
    ("update", Q, "20000001/10000000"),
    ("load", OTHER_Q, ""),
    ("at", OTHER_Q, "1"),
)


def answers(target: ScaledSum) -> list[str]:
    found = []
    for verb, second, scale in STEPS:
        if verb == "load":
            target.load(P, second)
        else:
            found.append(json.dumps(getattr(target, verb)(scale, scaled(P, Fraction(scale)))))
    return found


@pytest.mark.parametrize("name", [name for name, fault in FAULTS.items() if fault.needs_scale])
def test_the_fault_shows(name: str) -> None:
    assert answers(made(name)) != answers(made("sound"))


def test_any_other_fault_can_be_asked_by_the_program_too() -> None:
    assert answers(made("ignores_holes_of_q")) != answers(made("sound"))


def ask(name: str, requests: list[dict[str, Any]]) -> list[dict[str, Any]]:
    text = "".join(json.dumps({"seq": k, **each}) + "\n" for k, each in enumerate(requests))
    program = Path(__file__).parent / "seeded_adapter.py"
    ran = subprocess.run(
        [sys.executable, str(program), name],
        input=text,
        capture_output=True,
        text=True,
        check=True,
        timeout=20,
    )
    return [json.loads(line) for line in ran.stdout.splitlines()]


@pytest.mark.parametrize(("name", "reach"), [("sound", 10), ("scales_twice", 18)])
def test_the_program_speaks_the_protocol(name: str, reach: int) -> None:
    scale = {"scale": "2", "sP": scaled(P, Fraction(2))}
    hello, load, at, stop = ask(
        name,
        [
            {"verb": "hello", "protocols": ["adapter-v1"], "minkref": "0"},
            {"verb": "load", "dimension": 2, "P": P, "Q": OTHER_Q},
            {"verb": "at", **scale},
            {"verb": "stop"},
        ],
    )
    assert [each["seq"] for each in (hello, load, at, stop)] == [0, 1, 2, 3]
    assert hello["protocol"] == "adapter-v1" and "holes" in hello["capabilities"]
    assert load["status"] == at["status"] == "result"
    assert reach == max(int(x) for polygon in at["polygons"] for x, _ in polygon["outer"])
