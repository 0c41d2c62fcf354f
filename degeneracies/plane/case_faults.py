"""Checks each case in a corpus: id, place, and the certificate beside it."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from minkref.degeneracies.plane.case_texts import id_of


def of_place(
    path: Path, value: dict[str, Any], content: str, scales: list[str], seen: dict[str, Path]
) -> Iterator[str]:
    """`content`: equal for equal operands; `seen`: content of earlier cases."""
    family = value["tags"][0]
    if value["id"] != id_of(family, content, scales) or path.stem != value["id"]:
        yield f"{path}: the id is not that of the content"
    if path.parent.name != family:
        yield f"{path}: not in the folder of its family"
    if content in seen:
        yield f"{path}: the operands are those of {seen[content]}"
    seen[content] = path


def of_certificate(
    path: Path, value: dict[str, Any], content: str, names: Mapping[str, str]
) -> Iterator[str]:
    """Checks that the certificate names this case, whose digest is `content`, and claims every
    expected result. `names`: members of an expected result, with their names in a claim."""
    file = path.with_name(value["certificate"])
    if not file.exists():
        yield f"{path}: the certificate {file.name} is missing"
        return
    certificate = json.loads(file.read_text(encoding="utf-8"))
    if certificate["case"] != {"path": path.name, "sha256": content}:
        yield f"{file}: the certificate of another case"
    claimed = [
        [claim[name] for name in names.values()]
        for claim in certificate["claims"]
        if claim["claim"] == "sum"
    ]
    for expected in value["expected"]:
        if [expected.get(name) for name in names] not in claimed:
            yield f"{path}: what is expected at {_text(expected['scale'])} is not certified"
    yield from of_scales(path, value)


def of_scales(path: Path, value: dict[str, Any]) -> Iterator[str]:
    """Checks that each scale, and no other, has an expected result."""
    told = [_text(expected["scale"]) for expected in value["expected"]]
    if set(told) != set(map(_text, value["scales"])):
        yield f"{path}: not each scale has its expected result"


def _text(scale: Any) -> str:
    return scale if isinstance(scale, str) else ",".join(map(str, scale))
