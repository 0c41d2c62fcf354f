"""Bad input through the command line, and faults of the refusals."""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from minkref.reports.evidence.framework.part import Findings


@dataclass(frozen=True)
class Bad:
    """`places`: what the refusal has to name beside the file (words of the message)."""

    title: str
    file: str
    text: str | bytes
    codes: tuple[str, ...]
    places: tuple[str, ...] = ()
    scale: str = "1"
    beside: str = "g3"  # the other operand
    command: str = "sum"


def attempt(bad: Bad, folder: Path) -> dict[str, Any]:
    """Runs the command on the bad input; the refusal's faults, if any."""
    path, out = folder / bad.file, folder / f"{bad.file}.out.json"
    text = bad.text.encode() if isinstance(bad.text, str) else bad.text
    path.write_bytes(text)
    command = [
        sys.executable,
        "-m",
        "minkref",
        bad.command,
        str(path),
        bad.beside,
        f"--scale={bad.scale}",
    ]
    done = subprocess.run(
        [*command, "--json", "-o", str(out)], capture_output=True, text=True, timeout=60
    )
    faults = []
    if done.returncode != 2:
        faults.append(f"exit code {done.returncode}")
    if out.exists():
        faults.append("something was written")
    try:
        error = json.loads(done.stdout)["error"]
    except (ValueError, KeyError):
        error = {"code": "", "where": "", "what": done.stdout[:200], "mend": ""}
        faults.append("no document with an error")
    if error["code"] not in bad.codes:
        faults.append(f"code {error['code']!r}")
    if not error["mend"]:
        faults.append("no mend")
    told = f"{error['where']} {error['what']}"
    wanted = bad.places if bad.scale != "1" else (bad.file, *bad.places)
    faults += [f"{word!r} is not named" for word in wanted if word not in told]
    if len(told) > 2000:
        faults.append("a message of more than 2000 characters")
    return {"title": bad.title, "code": error["code"], "message": told[:300], "faults": faults}


def refuse_all(findings: Findings, inputs: list[Bad]) -> None:
    """The law that the command refuses every bad input properly."""
    with tempfile.TemporaryDirectory() as name, ThreadPoolExecutor(2) as pool:
        rows = list(pool.map(lambda bad: attempt(bad, Path(name)), inputs))
    for row in rows:
        print(row, flush=True)
    good = sum(not row["faults"] for row in rows)
    findings.figures["refusals"] = rows
    findings.equal("refused as they should be", len(inputs), good)
    for row in rows:
        if row["faults"]:
            findings.note(f"{row['title']}: {'; '.join(row['faults'])}")
