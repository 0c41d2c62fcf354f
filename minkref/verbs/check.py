"""`minkref check FILE|DIR...`: certificates, by a checker that trusts nobody."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated, Any

import typer
from minkref import proved_program
from minkref.cli.options import Json, Schema
from minkref.oracle.checker import check as checker
from minkref.output.documents import Stopwatch, as_text, document, scratch_folder
from minkref.output.terminal import escaped
from minkref.verbs import check_proved
from minkref.verbs.certificates_of import certificates_of
from minkref.verbs.unpacked import Unpacking

EXAMPLES = """Examples:

minkref check sum.cert.json

minkref check certificates/ --json

minkref check event.cert.json --case event.case.json --seconds 60

minkref check sum.cert.json --proved"""

MOST = 1e18
WORDS = {
    checker.VERIFIED: "verified",
    checker.REFUTED: "refuted",
    checker.MALFORMED: "malformed",
    checker.OUT_OF_BUDGET: "out of budget",
    check_proved.DECLINED: "declined",
}
WORST = (checker.REFUTED, checker.MALFORMED, checker.OUT_OF_BUDGET, check_proved.DECLINED)


def command(
    files: Annotated[
        list[Path],
        typer.Argument(
            help="Certificates, or folders of *.cert.json; - is standard input.",
            metavar="FILE|DIR...",
        ),
    ],
    case: Annotated[
        Path | None,
        typer.Option(
            "--case",
            help="Read the case from this file instead of the one that the certificate names.",
        ),
    ] = None,
    seconds: Annotated[
        float, typer.Option(help="Time limit for one certificate.", min=0, max=MOST)
    ] = 600.0,
    tests: Annotated[
        float, typer.Option(help="Most elementary tests for one certificate.", min=0, max=MOST)
    ] = 1e10,
    bytes_: Annotated[
        float,
        typer.Option(
            "--bytes", help="Largest size of a certificate or a case, unpacked.", min=0, max=MOST
        ),
    ] = 2**28,
    proved: Annotated[
        bool,
        typer.Option(
            "--proved",
            help="Then also by the checker that is proved right in Coq (`make proofs` builds it). "
            "It declines claims without a theorem: exit code 5.",
        ),
    ] = False,
    json: Json = False,
    schema: Schema = False,
) -> None:
    """Verify certificates (docs/certificates.md) step by step, in exact arithmetic, with none of
    the code that made them, in the plane, of convex polyhedra (docs/certificates-convex.md) and of
    any polyhedra (docs/certificates-solids.md), of paths and traps (docs/certificates-paths.md),
    bridges (docs/certificates-features.md), unions (docs/certificates-unions.md) and sums with a
    disc (docs/certificates-disc.md). The checker is a single file that also runs alone,
    oracle/checker/check.py. Exits with 0 if all are verified, 1 if one is refuted, 2 if one is
    malformed or its case is missing, 4 if one is out of budget, with --proved 5 if one has a claim
    that is not proved; 1 takes precedence over 2, 2 over 4, and 4 over 5. What is proved:
    docs/proved.md."""
    watch = Stopwatch()
    if proved:
        proved_program.program()
    rows: list[dict[str, Any]] = []
    for path, why_not in (found for given in files for found in certificates_of(given)):
        if why_not:
            rows.append({"file": str(path), "verdict": "malformed", "message": why_not})
            rows[-1] |= {"case": None, "claims": []}
            if not json:
                _print(rows[-1])
            continue
        read = Unpacking()
        limits = (seconds, tests, bytes_)
        code, message, said = checker.verdict(path, case, limits, (read.certificate, read))
        row: dict[str, Any] = {"file": str(path), "verdict": WORDS[code], "message": message}
        row |= {"case": _case(read, said), "claims": said[1:]}
        if proved and code == checker.VERIFIED:
            row |= {"checked": WORDS[code], **_proved(read, limits, said[1:])}
        rows.append(row)
        if not json:
            _print(row)
    if json:
        sys.stdout.write(as_text(document("check", watch, files=rows)))
    verdicts = {row["verdict"] for row in rows}
    raise typer.Exit(next((code for code in WORST if WORDS[code] in verdicts), checker.VERIFIED))


def _proved(read: Unpacking, limits: tuple[float, ...], claims: list[str]) -> dict[str, Any]:
    """The fields that the proved checker adds to a row. Its verdict is that of the row."""
    named = zip(("seconds", "tests", "bytes"), limits, strict=True)
    with scratch_folder() as folder:
        path, case = read.files(folder)
        options = [f"--case={case}", *(f"--{name}={limit!r}" for name, limit in named)]
        found = check_proved.follow(path, *options)
    return {
        "verdict": found.word, "message": found.why, "proved": found.proved,
        "not_proved": [] if found.word == "verified" else claims,
    }  # fmt: skip


def _case(read: Unpacking, said: list[str]) -> dict[str, str] | None:
    """The case of what is verified: its file, and its digest, which the checker says last."""
    if not said:
        return None
    return {"path": str(read.read[1][0]), "sha256": said[0].rpartition(" ")[2]}


def _print(row: dict[str, Any]) -> None:
    message = f": {escaped(row['message'])}" if row["message"] else ""
    sys.stdout.write(f"{escaped(row['file'])}: {row['verdict']}{message}\n")
    if row["case"]:
        sys.stdout.write(f"  case {escaped(row['case']['path'])}, {row['case']['sha256']}\n")
    by = "by check.py: " if "checked" in row else ""
    for claim in row["claims"]:
        sys.stdout.write(f"  {by}{escaped(claim)}\n")
    for name, word in (("proved", "proved"), ("not_proved", "not proved")):
        for line in row.get(name, ()):
            sys.stdout.write(f"  {word}: {escaped(line)}\n")
