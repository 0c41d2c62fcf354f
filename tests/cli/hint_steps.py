"""Steps that the hint of a refusal recommends, as command lines to be tried."""

from __future__ import annotations

import re
from collections.abc import Iterator

Words = list[str]

MEANT = re.compile(r"did you mean (\S+)\?")
CHOOSE = re.compile(r"choose (?:one of )?(.+?)(?:, or add --format (\S+))?$")
WRITE = re.compile(r"write ((?:[\w-]+=[^, ]+)(?:, [\w-]+=[^, ]+)*)$")
ADD = re.compile(r"\badd (--?[\w-]+(?: [A-Za-z][\w.-]*)?)")
ENDING = re.compile(r"name a (?:file that ends in )?(\.\w+)")
LEAVE = re.compile(r"leave (it|them|the option|--[\w-]+) out|leave out (--[\w-]+)")
PLACEHOLDERS = {
    "A": "1", "BITS": "53", "DIR": "made", "EPS": "1/1000", "FILE": "made", "PATH": "POINT (9 9)",
}  # fmt: skip


def steps(arguments: Words, where: str, mend: str) -> Iterator[Words]:
    """The command lines that follow the hint `mend` about the place `where`."""
    options = [word for word in re.split(r"[ ,]+", where) if _is_option(word) and word in arguments]
    wrong = _wrong(arguments, where, options)
    for found in MEANT.finditer(mend):
        yield _replaced(arguments, wrong, found[1])
    rest = MEANT.sub("", mend)
    for found in CHOOSE.finditer(rest):
        choices = re.split(r", or |, | or ", found[1])
        if all(re.fullmatch(r"\.?[\w:-]+", choice) for choice in choices):
            yield from (_replaced(arguments, wrong, choice) for choice in choices)
        if found[2]:
            yield [*arguments, "--format", found[2]]
    for found in WRITE.finditer(rest):
        for name, values in (part.split("=") for part in found[1].split(", ")):
            yield from (_replaced(arguments, wrong, f"{name}={v}") for v in values.split("|"))
    for found in ADD.finditer(rest):
        yield [*arguments, *(_filled(word) for word in found[1].split())]
    for found in ENDING.finditer(rest):
        yield _replaced(arguments, wrong, found[1])
    for found in LEAVE.finditer(rest):
        named = [word for word in found.groups() if word and _is_option(word)]
        yield _without(arguments, named or options)


def _is_option(word: str) -> bool:
    return re.fullmatch(r"--[\w-]+|-o", word) is not None


def _wrong(arguments: Words, where: str, options: Words) -> int:
    """The argument that `where` names: the option's value, or the word itself."""
    if options:
        return arguments.index(options[0]) + 1
    return next((k for k, word in enumerate(arguments) if k and word and word in where), -1)


def _filled(word: str) -> str:
    return re.sub(r"[A-Z]+", lambda name: PLACEHOLDERS.get(name[0], name[0]), word)


def _replaced(arguments: Words, at: int, word: str) -> Words:
    assert 0 <= at < len(arguments), f"no argument to put {word} in place of: {arguments}"
    word = _filled(f"made{word}" if word.startswith(".") else word)
    return [*arguments[:at], word, *arguments[at + 1 :]]


def _without(arguments: Words, options: Words) -> Words:
    """Drops options with their values: a word after an option is its value unless it is an option
    too."""
    rest: Words = []
    is_value = False
    for word in arguments:
        if word in options:
            is_value = True
            continue
        if not (is_value and not _is_option(word)):
            rest.append(word)
        is_value = False
    return rest
