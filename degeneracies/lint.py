"""Checks a corpus: schema, canonical form, ids, flags, certificates, no case twice; and compares
each case with its source's result. `python -m minkref.degeneracies.lint [FOLDER]`: a line for each
fault, exit code 1 on any fault."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import jsonschema
from minkref.degeneracies.case_texts import CaseTexts, canonical_text
from minkref.degeneracies.catalogue import GROUP_OF, OUTLINES, outline_of
from minkref.degeneracies.found import FOUND
from minkref.degeneracies.found import NAME as FOUND_NAME
from minkref.degeneracies.outline import CORPUS as CORPUS
from minkref.degeneracies.outline import Outline
from minkref.degeneracies.plane.flags import explained

ROOM = Path(__file__).parent
ENDING = ".cert.json"
GENERATE = "minkref generate"
WANTED = {"tags", "expected", "degeneracy"}


@cache
def validator(schema: str) -> jsonschema.Draft202012Validator:
    """A validator for the schema with this name."""
    text = (ROOM / "schema" / f"{schema}.json").read_text(encoding="utf-8")
    return jsonschema.Draft202012Validator(json.loads(text))


def case_paths(folder: Path) -> list[Path]:
    return sorted(p for p in folder.rglob("*.json") if not p.name.endswith(ENDING))


def faults(folder: Path = CORPUS, again: bool = True) -> Iterator[str]:
    """Yields a line for each fault. `again`: makes each case again from its source, to compare,
    which takes as long as generating. Certificates are compared with their cases, but not followed:
    for that, run `minkref check FOLDER`."""
    seen: dict[str, Path] = {}
    for path in case_paths(folder):
        text = path.read_text(encoding="utf-8")
        try:
            value = json.loads(text)
        except ValueError as error:
            yield f"{path}: {error}"
            continue
        outline = outline_of(value)
        found = validator(outline.case.schema).iter_errors(value)
        errors = [f"{e.json_path}: {e.message}" for e in found]
        absent = sorted(_wanted(outline) - set(value))
        errors += [f"the member {name} is missing" for name in absent]
        if errors:
            yield from (f"{path}: {error}" for error in errors)
            continue
        if text != canonical_text(value):
            yield f"{path}: not in canonical form"
        for flag in sorted(set(value.get("flags", [])) - outline.flags):
            yield f"{path}: the flag {flag} is not explained"
        yield from outline.faults(path, value, seen)
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
    given = {flag for outline in OUTLINES for flag in outline.flags}
    for flag in sorted(set(explained()) ^ given):
        yield f"flags.json: {flag} is explained and never given, or given and not explained"


def _wanted(outline: Outline) -> set[str]:
    """Members that the schema leaves open."""
    more = {"flags": outline.flags, "certificate": outline.certified}
    return WANTED | {name for name, has in more.items() if has}


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


def _made_again(value: dict[str, Any]) -> CaseTexts[Any] | None:
    if value["tags"][0] == FOUND_NAME:
        return next((one.case for one in FOUND if one.title == value.get("title")), None)
    words = str(value.get("source", "")).removeprefix(GENERATE).split()
    try:
        family = GROUP_OF[words[0]].families[words[0]]
        options = {words[i]: int(words[i + 1]) for i in range(1, len(words), 2)}
        made = (options["--seed"], options["--index"], options.get("--size"))
    except (IndexError, KeyError, ValueError):
        return None
    return outline_of(value).case.of(family, *made)


def main(arguments: list[str]) -> int:
    folder = Path(arguments[0]) if arguments else CORPUS
    found = [*faults(folder), *(corpus_faults() if folder == CORPUS else ())]
    for fault in found:
        print(fault)
    print(f"{folder}: {len(case_paths(folder))} cases, {len(found)} faults")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
