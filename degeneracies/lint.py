"""What must hold of a corpus: schema, canonical form, ids, flags, certificates, no case twice."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import jsonschema
from minkref import _core
from minkref.certify.case_text import case_digest
from minkref.degeneracies.case_document import canonical_text, id_of

ROOM = Path(__file__).parent
CORPUS = ROOM / "corpus"
ENDING = ".cert.json"


def flags() -> dict[str, dict[str, Any]]:
    """What each flag means, what it breaks, who is known to be broken by it."""
    value: dict[str, dict[str, Any]] = json.loads((ROOM / "flags.json").read_text(encoding="utf-8"))
    return value


def case_paths(folder: Path) -> list[Path]:
    return sorted(p for p in folder.rglob("*.json") if not p.name.endswith(ENDING))


def faults(folder: Path = CORPUS) -> Iterator[str]:
    """A line for each fault. Certificates are compared with their cases, not followed: that is
    `minkref check FOLDER`."""
    schema = json.loads((ROOM / "schema" / "case-v1.json").read_text(encoding="utf-8"))
    validator = jsonschema.Draft202012Validator(schema)
    known, used = flags(), set[str]()
    seen: dict[str, Path] = {}
    paths = case_paths(folder)
    for path in paths:
        text = path.read_text(encoding="utf-8")
        value = json.loads(text)
        for error in validator.iter_errors(value):
            yield f"{path}: {error.json_path}: {error.message}"
        if text != canonical_text(value):
            yield f"{path}: not in canonical form"
        used |= set(value["flags"])
        for flag in set(value["flags"]) - set(known):
            yield f"{path}: the flag {flag} is not explained"
        operands = [_core.PolygonSet.from_json(json.dumps(value[name])) for name in "PQ"]
        content = case_digest(*operands)
        family = value["tags"][0]
        if value["id"] != id_of(family, content, value["scales"]) or path.stem != value["id"]:
            yield f"{path}: the id is not that of the content"
        if path.parent.name != family:
            yield f"{path}: not in the folder of its family"
        if content in seen:
            yield f"{path}: the operands are those of {seen[content]}"
        seen[content] = path
        yield from _certificate_faults(path, value, content)
    for flag in sorted(set(known) - used):
        yield f"flags.json: no case has the flag {flag}"
    for path in sorted(folder.rglob(f"*{ENDING}")):
        if not path.with_name(path.name.removesuffix(ENDING) + ".json").exists():
            yield f"{path}: a certificate without its case"


def _certificate_faults(path: Path, value: dict[str, Any], content: str) -> Iterator[str]:
    """The certificate is of this case, and claims all that is expected."""
    file = path.with_name(value["certificate"])
    if not file.exists():
        yield f"{path}: the certificate {file.name} is missing"
        return
    certificate = json.loads(file.read_text(encoding="utf-8"))
    if certificate["case"] != {"path": path.name, "sha256": content}:
        yield f"{file}: the certificate of another case"
    names = ("scale", "components", "holes", "digest")
    claimed = {
        tuple(claim[name] for name in names)
        for claim in certificate["claims"]
        if claim["claim"] == "sum"
    }
    for expected in value["expected"]:
        if tuple(expected[name] for name in names) not in claimed:
            yield f"{path}: what is expected at {expected['scale']} is not certified"
    if {expected["scale"] for expected in value["expected"]} != set(value["scales"]):
        yield f"{path}: not each scale has its expected result"
