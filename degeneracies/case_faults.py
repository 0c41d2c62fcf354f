"""Checks of a case in a corpus that all settings need: id, place, and the certificate beside it."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any

from minkref.degeneracies.case_texts import id_of, text_of

Claims = list[dict[str, Any]]


def of_place(
    path: Path,
    value: dict[str, Any],
    content: str,
    scales: list[str],
    seen: dict[str, Path],
    key: str | None = None,
) -> Iterator[str]:
    """`content`: equal for equal operands; `key`: for equal cases, if different cases have equal
    operands; `seen`: contents or keys of earlier cases."""
    family = value["tags"][0]
    if value["id"] != id_of(family, content, scales) or path.stem != value["id"]:
        yield f"{path}: the id is not that of the content"
    if path.parent.name != family:
        yield f"{path}: not in the folder of its family"
    same, what = (content, "operands are those") if key is None else (key, "case is that")
    if same in seen:
        yield f"{path}: the {what} of {seen[same]}"
    seen[same] = path


def of_certificate(
    path: Path, value: dict[str, Any], content: str, of_claims: Callable[[Claims], Iterator[str]]
) -> Iterator[str]:
    """Checks that the certificate names this case, whose digest is `content`; `of_claims` checks
    its claims."""
    file = path.with_name(value["certificate"])
    if not file.exists():
        yield f"{path}: the certificate {file.name} is missing"
        return
    certificate = json.loads(file.read_text(encoding="utf-8"))
    if certificate["case"] != {"path": path.name, "sha256": content}:
        yield f"{file}: the certificate of another case"
    yield from of_claims(certificate["claims"])


def of_sums(
    path: Path, value: dict[str, Any], content: str, names: Mapping[str, str]
) -> Iterator[str]:
    """Checks that the certificate claims every expected result. `names`: members of an expected
    result, with their names in a claim."""

    def of_claims(claims: Claims) -> Iterator[str]:
        claimed = [
            [claim[name] for name in names.values()] for claim in claims if claim["claim"] == "sum"
        ]
        for expected in value["expected"]:
            if [expected.get(name) for name in names] not in claimed:
                yield f"{path}: what is expected at {text_of(expected['scale'])} is not certified"
        yield from of_scales(path, value)

    return of_certificate(path, value, content, of_claims)


def of_scales(path: Path, value: dict[str, Any]) -> Iterator[str]:
    """Checks that each scale, and no other, has an expected result."""
    told = {text_of(expected["scale"]) for expected in value["expected"]}
    if told != set(map(text_of, value["scales"])):
        yield f"{path}: not each scale has its expected result"
