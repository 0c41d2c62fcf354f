"""The whole event array of the paper's program, against digests from an earlier computation: one
thread worked each pair out to its end, with a separate MPFR number for each result."""

from __future__ import annotations

import hashlib

import pytest
from minkref import _core
from minkref.plane.operand import read_operand
from thoroughness import THOROUGH

CORRECTED = {name: corrected for name, _, corrected, _ in _core.paper_readings()}
PRINTED = {name: values[0] for name, values, *_ in _core.paper_readings()}
READINGS = {"corrected": CORRECTED, "printed": PRINTED}
ARITHMETICS = ("double", "mpfr:53", "mpfr:200", "mpfr:1000")
# Digests for each pair and reading, ordered like ARITHMETICS.
DIGESTS = {
    ("g1", "g2", "corrected"): (
        "b677a2c7521cf456bcb0dbdf",
        "b677a2c7521cf456bcb0dbdf",
        "73e0a44845ae58700715be90",
        "5a5fcd3a11a07b4f802ac593",
    ),
    ("g1", "g2", "printed"): (
        "46e28155a15354c53a20f867",
        "46e28155a15354c53a20f867",
        "f5c44be2aacdae7e8df90ab0",
        "36eb7ecf93b25eb60d985227",
    ),
    ("g3", "g1", "corrected"): (
        "4d7818972b119d10df3073f7",
        "4d7818972b119d10df3073f7",
        "1f3a64643526ff4e23703101",
        "532ad67ef0d904a8743591ef",
    ),
    ("g3", "g1", "printed"): (
        "9fed3d2843db2d34367c20b9",
        "9fed3d2843db2d34367c20b9",
        "55c0c0c272d58113c3715d41",
        "0525fb6cc4e1d93419496caf",
    ),
    ("disc1", "g1", "corrected"): (
        "3540dd1299a3aee5a51e1209",
        "3540dd1299a3aee5a51e1209",
        "cabbb27daef7ede082115302",
        "07a637c29111133cb58f0c77",
    ),
    ("disc1", "g1", "printed"): (
        "2ab6602d5a25e36cb4e4d167",
        "2ab6602d5a25e36cb4e4d167",
        "0ce11e377763dabcf9b2f169",
        "b783efae2a7749c21253cd1e",
    ),
    ("g2", "g4", "corrected"): (
        "6d2133cb28d1a16e49fc017c",
        "6d2133cb28d1a16e49fc017c",
        "91b365549e2f091e7e4d81a1",
        "f2c92e096fb3ccb20661502e",
    ),
    ("g2", "g4", "printed"): (
        "9cb48b1fb4e5b79adc5a5924",
        "9cb48b1fb4e5b79adc5a5924",
        "4432ee4832e5bd73ce798ff4",
        "24590a14da45fde2972ffac2",
    ),
    ("g3", "g2", "corrected"): (
        "baa2b5561f75791954fb36bc",
        "baa2b5561f75791954fb36bc",
        "c3abd90a7f84a62155610451",
        "6f25c7e4a095fd724c8879ba",
    ),
    ("g3", "g2", "printed"): (
        "85b5f9117ab81af6b47e7f00",
        "85b5f9117ab81af6b47e7f00",
        "f73493ad0b69f086dae00f94",
        "ff6ff71b27a4c150b587f9a5",
    ),
}


def digest(names: tuple[str, str], arithmetic: str, form: str, threads: int) -> str:
    P, Q = (read_operand(name).set for name in names)
    program = _core.PaperUpdate(P, Q, "1", arithmetic, READINGS[form], threads)
    total = hashlib.sha256()
    for event in program.events():
        total.update(repr(event).encode())
    return total.hexdigest()[:24]


@pytest.mark.parametrize(("P", "Q", "form"), DIGESTS)
def test_no_event_has_changed(P: str, Q: str, form: str) -> None:
    """Takes two arithmetics in turn; all if the run is thorough."""
    turn = list(DIGESTS).index((P, Q, form)) // 2 % 2
    for k in range(4) if THOROUGH else (turn, turn + 2):
        assert digest((P, Q), ARITHMETICS[k], form, 1) == DIGESTS[P, Q, form][k]


@pytest.mark.parametrize("arithmetic", ARITHMETICS)
@pytest.mark.parametrize("threads", [2, 3, 64])
def test_threads_change_nothing(arithmetic: str, threads: int) -> None:
    for form in READINGS if THOROUGH else [list(READINGS)[threads % 2]]:
        wanted = DIGESTS[("g1", "g2", form)][ARITHMETICS.index(arithmetic)]
        assert digest(("g1", "g2"), arithmetic, form, threads) == wanted


def test_what_an_interval_cannot_tell_ends_all_threads() -> None:
    P, Q = (read_operand(name).set for name in ("g1", "g2"))
    with pytest.raises(_core.UndecidedSign):
        _core.PaperUpdate(P, Q, "1", "interval", CORRECTED, 4)
