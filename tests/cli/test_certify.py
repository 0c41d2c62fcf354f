"""`minkref certify` and `minkref check`."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

import pytest
from minkref.certify.plane.certificate import Certificate
from minkref.reports.evidence.certificates.checkers import in_cpp

TRIANGLE = "POLYGON((-3 -2, 4 -1, 1 3, -3 -2))"
FRAME = "POLYGON((-40 -40, 40 -40, 40 40, -40 40, -40 -40), (0 20, 17 -11, -19 -9, 0 20))"


@pytest.fixture
def operands(tmp_path: Path) -> tuple[str, str]:
    for name, text in (("P", TRIANGLE), ("Q", FRAME)):
        (tmp_path / f"{name}.wkt").write_text(text, encoding="utf-8")
    return str(tmp_path / "P.wkt"), str(tmp_path / "Q.wkt")


@pytest.mark.parametrize(
    ("options", "claims"),
    [
        ([], ["sum"]),
        (["--scale", "541/186"], ["sum"]),
        (["--scale", "541/186", "--all-passages"], ["sum", "passage", "passages"]),
        (["--event", "541/186"], ["interval", "sum", "interval", "event"]),
        (["--from", "1", "--to", "541/186"], ["interval"]),
        (["--events", "--from", "1", "--to", "541/186"], ["interval", "events"]),
        (["--events", "--from", "2", "--to", "3"], ["interval", "sum", "interval", "event"]),
        (["--degeneracy", "541/186"], ["sign", "sign", "sign"]),
        (["--scale", "2", "--point", "45,1/3"], ["point"]),
        (["--point", "0,0"], ["outside"]),
    ],
)
@pytest.mark.parametrize("ending", [".cert.json", ".cert.json.gz"])
def test_what_is_certified_is_verified(
    minkref: Any, operands: Any, tmp_path: Path, options: list[str], claims: list[str], ending: str
) -> None:
    file = tmp_path / f"it{ending}"
    ran = minkref("certify", *operands, *options, "-o", str(file), "--json")
    assert ran.code == 0, ran.err
    made = [claim["claim"] for claim in ran.json["claims"]]
    more = {"passage", "passages", "events"}
    assert made[: len(claims)] == claims and set(made[len(claims) :]) <= more
    checked = minkref("check", str(tmp_path), "--json")
    assert checked.code == 0
    (row,) = checked.json["files"]
    assert (row["file"], row["verdict"], len(row["claims"])) == (str(file), "verified", len(made))
    spoilt = json.loads((tmp_path / "it.case.json").read_text(encoding="utf-8"))
    spoilt["P"]["polygons"][0]["outer"][0][0] = "-4"
    (tmp_path / "it.case.json").write_text(json.dumps(spoilt), encoding="utf-8")
    refused = minkref("check", str(file))
    assert refused.code == 1
    assert "refuted" in refused.out


@pytest.mark.parametrize(
    ("options", "why"),
    [
        (["--event", "2"], "has no event at 2"),
        (["--from", "2", "--to", "3"], "has an event at"),
        (["--from", "2"], "an interval has two ends"),
        (["--all-passages", "--event", "2"], "passages are those of a sum"),
        (["--all-passages", "--point", "2,3"], "passages are those of a sum"),
        (["--all-passages", "--theorem", "sum.v"], "no theorem about all passages"),
        (["--events"], "events are those between two scales"),
        (["--events", "--event", "3", "--from", "1"], "events are those between two scales"),
        (["--from", "2", "--to", "1"], "the interval is empty"),
        (["--event", "1", "--from", "2"], "not below the event"),
        (["--event", "1", "--scale", "2"], "do not go together"),
        (["--degeneracy", "1", "--scale", "2"], "do not go together"),
        (["--degeneracy", "1", "--from", "2"], "do not go together"),
        (["--event", "1", "--point", "2,3"], "do not go together"),
        (["--degeneracy", "2"], "start or stop meeting at 2"),
        (["--point", "0"], "not a point"),
        (["--point", "0,x"], "the point is not a number"),
        (["--scale", "0"], "--scale"),
    ],
)
def test_what_cannot_be_certified_is_refused(
    minkref: Any, operands: Any, tmp_path: Path, options: list[str], why: str
) -> None:
    before = sorted(tmp_path.iterdir())
    ran = minkref("certify", *operands, *options, "-o", str(tmp_path / "it.cert.json"))
    assert (ran.code, why in ran.err) == (2, True), ran.err
    assert sorted(tmp_path.iterdir()) == before


def test_a_certificate_has_a_name_that_check_finds(
    minkref: Any, operands: Any, tmp_path: Path
) -> None:
    ran = minkref("certify", *operands, "-o", str(tmp_path / "it.json"))
    assert (ran.code, ".cert.json" in ran.err) == (2, True)
    assert minkref("check", str(tmp_path)).code == 2
    assert minkref("check", str(tmp_path / "nowhere.cert.json")).code == 2


def test_a_limit_is_undecided(minkref: Any, operands: Any, tmp_path: Path) -> None:
    file = tmp_path / "it.cert.json"
    minkref("certify", *operands, "-o", str(file))
    assert minkref("check", str(file), "--tests", "5").code == 4


def test_the_case_is_one_that_other_commands_read(
    minkref: Any, operands: Any, tmp_path: Path
) -> None:
    """Nor does it overwrite another file with its name."""
    minkref("certify", *operands, "-o", str(tmp_path / "it.cert.json"))
    case = tmp_path / "it.case.json"
    ran = minkref("sum", f"{case}#P", f"{case}#Q", "--json")
    assert (ran.code, ran.json["holes"]) == (0, 1)
    again = minkref("certify", *operands, "--scale", "2", "-o", str(tmp_path / "it.cert.json.gz"))
    assert again.code == 0
    case.write_text("mine", encoding="utf-8")
    ran = minkref("certify", *operands, "-o", str(tmp_path / "it.cert.json"))
    assert (ran.code, "another file" in ran.err) == (2, True)
    assert case.read_text(encoding="utf-8") == "mine"


def test_names_beyond_ascii(minkref: Any, operands: Any, tmp_path: Path) -> None:
    file = tmp_path / "é\U0001d54a.cert.json"
    assert minkref("certify", *operands, "-o", str(file)).code == 0
    assert minkref("check", str(file)).code == 0
    program = in_cpp()
    assert subprocess.run([*program, str(file)], capture_output=True).returncode == 0


def test_what_is_no_proof_is_our_fault_and_is_not_written(
    minkref: Any, operands: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Tests a producer that claims a sum different from the proven one."""
    text = Certificate.text

    def false_text(certificate: Certificate, *arguments: Any) -> str:
        certificate.claims[0]["holes"] += 1
        return text(certificate, *arguments)

    monkeypatch.setattr(Certificate, "text", false_text)
    file = tmp_path / "it.cert.json"
    ran = minkref("certify", *operands, "-o", str(file))
    assert ran.code == 70
    assert "that is no proof, and has not written it: claim 0: components or holes" in ran.err
    assert not file.exists() and not (tmp_path / "it.case.json").exists()
    unchecked = minkref("certify", *operands, "-o", str(file), "--no-check")
    assert unchecked.code == 0
    assert "not checked (--no-check)" in unchecked.out
    assert minkref("check", str(file)).code == 1


@pytest.mark.parametrize("bodies", [("gs3", "rod")])
def test_it_says_that_it_was_checked(minkref: Any, tmp_path: Path, bodies: tuple[str, str]) -> None:
    for names in (bodies, ("g1", "g2")):
        ran = minkref("certify", *names, "-o", str(tmp_path / f"{names[0]}.cert.json"))
        assert "checked: verified" in ran.out
