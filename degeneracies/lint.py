"""Checks a corpus: schema, canonical form, ids, flags, certificates, no case twice; and compares
each case with its source's result. `python -m minkref.degeneracies.lint [FOLDER]`: a line for each
fault, exit code 1 on any fault."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import jsonschema
from minkref import _core
from minkref.certify.case_text import case_digest
from minkref.degeneracies.catalogue import ALL_FAMILIES
from minkref.degeneracies.files import AnyDegenerate, member_of
from minkref.degeneracies.found import FOUND
from minkref.degeneracies.found import NAME as FOUND_NAME
from minkref.degeneracies.plane.case_document import Degenerate, content_of
from minkref.degeneracies.plane.case_faults import of_certificate, of_place
from minkref.degeneracies.plane.case_texts import canonical_text
from minkref.degeneracies.plane.flags import FLAGS, explained
from minkref.degeneracies.solids.case_faults import case_faults as case_faults_of_solids
from minkref.degeneracies.solids.flags import FLAGS_OF_SOLIDS
from minkref.degeneracies.space.case_faults import case_faults as case_faults_in_space
from minkref.degeneracies.space.flags import FLAGS_IN_SPACE

ROOM = Path(__file__).parent
CORPUS = ROOM / "corpus"
ENDING = ".cert.json"
GENERATE = "minkref generate"
CERTIFIED = ("scale", "components", "holes", "digest")
WANTED = {"tags", "flags", "expected", "degeneracy"}


def case_paths(folder: Path) -> list[Path]:
    return sorted(p for p in folder.rglob("*.json") if not p.name.endswith(ENDING))


def faults(folder: Path = CORPUS, again: bool = True) -> Iterator[str]:
    """Yields a line for each fault. `again`: makes each case again from its source, to compare,
    which takes as long as generating. Certificates are compared with their cases, but not followed:
    for that, run `minkref check FOLDER`."""
    schema = json.loads((ROOM / "schema" / "case-v1.json").read_text(encoding="utf-8"))
    validator = jsonschema.Draft202012Validator(schema)
    seen: dict[str, Path] = {}
    for path in case_paths(folder):
        text = path.read_text(encoding="utf-8")
        try:
            value = json.loads(text)
        except ValueError as error:
            yield f"{path}: {error}"
            continue
        errors = [f"{e.json_path}: {e.message}" for e in validator.iter_errors(value)]
        kind = _kind(value)
        absent = sorted((WANTED | kind.certified) - set(value))
        errors += [f"the member {name} is missing" for name in absent]
        if errors:
            yield from (f"{path}: {error}" for error in errors)
            continue
        if text != canonical_text(value):
            yield f"{path}: not in canonical form"
        for flag in sorted(set(value["flags"]) - kind.flags):
            yield f"{path}: the flag {flag} is not explained"
        yield from kind.faults(path, value, seen)
        if again:
            yield from _differences(path, value)
    for path in sorted(folder.rglob(f"*{ENDING}")):
        if not path.with_name(path.name.removesuffix(ENDING) + ".json").exists():
            yield f"{path}: a certificate without its case"


def corpus_faults(folder: Path = CORPUS) -> Iterator[str]:
    """Faults of the whole corpus: flags without a case or an explanation."""
    used = {
        flag
        for path in case_paths(folder)
        for flag in json.loads(path.read_text(encoding="utf-8"))["flags"]
    }
    for flag in sorted(set(explained()) - used):
        yield f"flags.json: no case has the flag {flag}"
    for flag in sorted(set(explained()) ^ {*FLAGS, *FLAGS_IN_SPACE, *FLAGS_OF_SOLIDS}):
        yield f"flags.json: {flag} is explained and never given, or given and not explained"


@dataclass(frozen=True)
class _Kind:
    """A kind of case: plane, convex bodies in space, or polyhedra of any shape."""

    flags: frozenset[str]
    faults: Callable[[Path, dict[str, Any], dict[str, Path]], Iterator[str]]
    certified: frozenset[str] = frozenset({"certificate"})


def _kind(value: Any) -> _Kind:
    if not isinstance(value, dict) or value.get("dimension") != 3:
        return _Kind(frozenset(FLAGS), _case_faults)
    told = value.get("degeneracy")
    if isinstance(told, dict) and "ties" in told:
        return _Kind(frozenset(FLAGS_OF_SOLIDS), case_faults_of_solids, frozenset())
    return _Kind(frozenset(FLAGS_IN_SPACE), case_faults_in_space)


def _case_faults(path: Path, value: dict[str, Any], seen: dict[str, Path]) -> Iterator[str]:
    """Yields faults of a case in the plane."""
    try:
        operands = [_core.PolygonSet.from_json(json.dumps(value[name])) for name in "PQ"]
        for name, operand in zip("PQ", operands, strict=True):
            operand.validate(name)
    except _core.BadInput as error:
        yield f"{path}: {error}"
        return
    content = content_of(operands[0], operands[1])
    yield from of_place(path, value, content, value["scales"], seen)
    certified = case_digest(operands[0], operands[1])
    yield from of_certificate(path, value, certified, {name: name for name in CERTIFIED})


def _differences(path: Path, value: dict[str, Any]) -> Iterator[str]:
    """Yields differences between a case with its certificate and its source's result."""
    made = _made_again(value)
    if made is None:
        yield f"{path}: the source {value.get('source')!r} makes nothing"
        return
    document = json.loads(made.case_text)
    for name in sorted(set(document) | set(value)):
        if document.get(name) != value.get(name):
            yield f"{path}: {name} is not what the source makes"
    parts, others = document["degeneracy"], value["degeneracy"]
    for name in sorted(set(parts) | set(others)):
        if parts.get(name) != others.get(name):
            yield f"{path}: {name} of degeneracy is not what the source makes"
    if made.certificate_text is None:
        return
    file = path.with_name(value["certificate"])
    if file.exists() and file.read_text(encoding="utf-8") != made.certificate_text:
        yield f"{file}: not the certificate that the source makes"


def _made_again(value: dict[str, Any]) -> AnyDegenerate | None:
    if value["tags"][0] == FOUND_NAME:
        return next(
            (
                Degenerate(story, story.value["source"], story.facts)
                for story in FOUND
                if story.title == value.get("title")
            ),
            None,
        )
    words = str(value.get("source", "")).removeprefix(GENERATE).split()
    try:
        family = ALL_FAMILIES[words[0]]
        options = {words[i]: int(words[i + 1]) for i in range(1, len(words), 2)}
        made = (options["--seed"], options["--index"], options.get("--size"))
    except (IndexError, KeyError, ValueError):
        return None
    return member_of(family, *made)


def main(arguments: list[str]) -> int:
    folder = Path(arguments[0]) if arguments else CORPUS
    found = [*faults(folder), *(corpus_faults() if folder == CORPUS else ())]
    for fault in found:
        print(fault)
    print(f"{folder}: {len(case_paths(folder))} cases, {len(found)} faults")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
