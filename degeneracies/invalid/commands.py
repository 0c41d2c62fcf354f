"""The commands that read operands, and how each receives a member of a family of invalid input."""

from __future__ import annotations

from pathlib import Path

from minkref.degeneracies.invalid.member import Invalid

# P, Q: the operands; S: the scale; it: the output. The member stands for P or Q, a triangle for the
# other operand.
COMMANDS: dict[str, tuple[str, ...]] = {
    "sum": ("sum", "P", "Q", "--scale=S", "-o", "it.json"),
    "convolution": ("convolution", "P", "Q", "--scale=S", "-o", "it.json"),
    "events": ("events", "P", "Q", "--from=S", "-o", "it.json"),
    "sweep": ("sweep", "P", "Q", "--from=S", "--to=2", "--steps=2", "-o", "it"),
    "path": ("path", "P", "Q", "POINT(0 0)", "--from=S", "-o", "it.json"),
    "view": ("view", "P", "Q", "--from=S", "--to=2", "-o", "it.html"),
    "certify": ("certify", "P", "Q", "--scale=S", "-o", "it.cert.json"),
    "verify": ("verify", "minkref", "--case", "P+Q@S", "--junit", "it.xml", "--lines", "it.jsonl"),
    "shrink": ("shrink", "P+Q@S", "--target", "minkref", "-o", "it.json"),
}
OTHER = "POLYGON((0 0, 2 0, 1 3, 0 0))"


def written(member: Invalid, folder: Path) -> str:
    """Writes the member's file to the folder; returns the argument that names the operand."""
    (folder / member.file_name).write_bytes(member.content)
    return str(folder / member.argument)


def words(command: str, member: Invalid, folder: Path) -> list[str]:
    """The command line. The operands are in the folder now, and the output would be."""
    other = folder / "valid.wkt"
    other.write_text(OTHER, encoding="utf-8")
    P, Q = written(member, folder), str(other)
    if member.operand == "Q":
        P, Q = Q, P
    scale = "1" if member.scale is None else member.scale
    filled = []
    for word in COMMANDS[command]:
        if word in ("P", "Q", "P+Q@S"):
            word = {"P": P, "Q": Q, "P+Q@S": f"{P}+{Q}@{scale}"}[word]
        elif word.startswith("it"):
            word = str(folder / word)
        filled.append(word[:-1] + scale if word.endswith("=S") else word)
    return filled


def left_out(member: Invalid, text: str) -> list[str]:
    """Texts that a good message would hold and this message lacks: the damaged place, and the name
    of the file, or of the scale's option."""
    named = member.file_name if member.scale is None else "--"
    return [each for each in (*member.place, named) if each not in text]
