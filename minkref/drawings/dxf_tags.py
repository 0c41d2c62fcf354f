"""The groups of a DXF file in ASCII: entities with their values as texts."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from minkref.drawings.reading import Reading

BINARY = b"AutoCAD Binary DXF"
LINE_END = re.compile("\r\n|\r|\n")  # no others, as texts in old encodings have their bytes


@dataclass
class Entity:
    """`values`: group codes with values, in order; `line`: the first line."""

    kind: str
    line: int
    values: list[tuple[int, str]] = field(default_factory=list)

    def first(self, code: int, default: str = "") -> str:
        return next((value for each, value in self.values if each == code), default)

    def all(self, code: int) -> list[str]:
        return [value for each, value in self.values if each == code]

    def flags(self, code: int) -> int:
        """Read flags; 0 for any other word."""
        text = self.first(code, "0").strip()
        return int(text) if text.lstrip("-").isdecimal() else 0


def sections(data: bytes, reading: Reading) -> dict[str, list[Entity]]:
    """Split a file into sections with entities; header variables count as entities too. Refuses
    binary files, files that end too early, and other texts."""
    if data.startswith(BINARY):
        raise reading.refusal(
            "this is a binary DXF file", "save it as DXF in ASCII", "unsupported-encoding"
        )
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = data.decode("latin-1")
    lines = LINE_END.split(text)
    found: dict[str, list[Entity]] = {}
    section: list[Entity] | None = None
    for k in range(0, len(lines) - 1, 2):
        word, value = lines[k].strip(), lines[k + 1].strip()
        if not word.lstrip("-").isdecimal():
            mend = "give a DXF file: a line with a code, then a line with its value, and so on"
            raise reading.refusal(
                f"there is {word[:40]!r} for a group code", mend, "syntax", f"line {k + 1}"
            )
        code = int(word)
        if code == 2 and section is None:
            section = found.setdefault(value, [])
        elif code == 0 and value in ("SECTION", "ENDSEC", "EOF"):
            section = None
            if value == "EOF":
                break
        elif section is not None and (code == 0 or code == 9):
            section.append(Entity(value, k + 2))
        elif section:
            section[-1].values.append((code, value))
    mend = "give a complete DXF file"
    if "ENTITIES" not in found:
        raise reading.refusal("the file has no section ENTITIES", mend, "truncated")
    if section is not None:
        raise reading.refusal("the file ends within a section", mend, "truncated")
    return found
