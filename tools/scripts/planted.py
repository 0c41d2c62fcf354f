#!/usr/bin/env python3
"""Faults that are put into the reference: one patch of tests/planted/ for each.

planted.py copy FOLDER                a checkout of links, with all faults in its reference/
planted.py edit FAULT [FILE...]       the files of a fault in build/planted/, with this fault alone
planted.py record FAULT [WHAT]        its patch anew, from these files

A new FAULT is named with its folder, as plane/NAME, with the FILEs that it is put into, and with
WHAT is wrong. Each patch is made for the sources as they are, so that the others do not matter.
"""

from __future__ import annotations

import difflib
import re
import shutil
import sys
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PATCHES = Path("tests", "planted")
EDITED = Path("build", "planted")
HOOKED = "reference"  # the room that faults are put into
SWITCH = f'#include "{PATCHES}/fault.hpp"\n'
NOT_LINKED = {HOOKED, "build", "dist"}
Change = tuple[int, int, list[str], Path]  # from which line to which, by what, and whose


class Misfit(ValueError):
    """A patch and the sources, or two patches, do not go together."""


@dataclass(frozen=True)
class Hunk:
    """A change of a file; its lines begin with a blank, - or +."""

    file: str
    first: int  # line of the file, when the patch was made
    lines: tuple[str, ...]

    def old(self) -> list[str]:
        return [line[1:] for line in self.lines if line[0] != "+"]

    def changes(self, at: int) -> Iterator[tuple[int, int, list[str]]]:
        """From which line to which is replaced, and by what, if the hunk begins at a line."""
        start, new = at, list[str]()
        for line in (*self.lines, " "):
            if line[0] == " ":
                if at > start or new:
                    yield start, at, new
                start, new = at + 1, []
            if line[0] == "+":
                new.append(line[1:])
            else:
                at += 1


def names_of(patch: Path) -> list[str]:
    """The faults of a patch: some have lines that cannot be apart."""
    return patch.stem.split("+")


def patches() -> list[Path]:
    return sorted((ROOT / PATCHES).glob("*/*.patch"))


def described(patch: Path) -> dict[str, str]:
    """What is wrong with each fault, by the lines before the first file."""
    head = patch.read_text(encoding="utf-8").partition("\n--- ")[0]
    return dict(line.split(": ", 1) for line in head.splitlines() if ": " in line)


def listed(folder: str = "*") -> dict[str, str]:
    """The faults, or those of a folder, with what is wrong, in the order of fault.hpp."""
    texts: dict[str, str] = {}
    for patch in (ROOT / PATCHES).glob(f"{folder}/*.patch"):
        texts |= described(patch)
    names = re.findall(r"^  X\((\w+)\)", (ROOT / PATCHES / "fault.hpp").read_text("utf-8"), re.M)
    return {name: texts[name] for name in names if name in texts}


def hunks(patch: Path) -> list[Hunk]:
    found: list[tuple[str, int, list[str]]] = []
    file = ""
    for line in patch.read_text(encoding="utf-8").splitlines(keepends=True):
        if line.startswith("--- a/"):
            file = line.removeprefix("--- a/").strip()
        elif line.startswith("@@ "):
            found.append((file, int(line.split(",")[0].removeprefix("@@ -")), []))
        elif found and not line.startswith("+++ b/"):
            found[-1][2].append(line if line != "\n" else " \n")
    return [Hunk(file, first, tuple(lines)) for file, first, lines in found]


def place(hunk: Hunk, lines: list[str]) -> int:
    """The line at which the hunk begins. All its old lines are there, once, or where they were."""
    old = hunk.old()
    at = [k for k in range(len(lines) - len(old) + 1) if lines[k : k + len(old)] == old]
    if hunk.first - 1 in at:
        return hunk.first - 1
    if len(at) != 1:
        raise Misfit(f"{hunk.file} has these lines {len(at)} times:\n" + "".join(hunk.lines))
    return at[0]


def patched(some: list[Path], left_out: list[Misfit] | None = None) -> dict[str, str]:
    """The files of these patches with all of them applied, by name. What does not apply is told, or
    left out where there is a list for it."""
    changes: dict[str, list[Change]] = defaultdict(list)
    sources: dict[str, list[str]] = {}
    for patch in some:
        for hunk in hunks(patch):
            lines = sources.setdefault(hunk.file, lines_of(ROOT / hunk.file))
            try:
                changes[hunk.file] += ((*one, patch) for one in hunk.changes(place(hunk, lines)))
            except Misfit as misfit:
                if left_out is None:
                    raise Misfit(f"{patch.name} does not apply: {misfit}{_mend(patch)}") from None
                left_out.append(misfit)
    return {file: _changed(lines, changes[file]) for file, lines in sources.items()}


def lines_of(file: Path) -> list[str]:
    return file.read_text(encoding="utf-8").splitlines(keepends=True) if file.is_file() else []


def _changed(lines: list[str], changes: list[Change]) -> str:
    result: list[str] = []
    done, inserted_at = 0, -1
    for start, end, new, patch in sorted(changes, key=lambda change: change[:2]):
        if start < done or start == end == inserted_at:
            raise Misfit(f"{patch.name} changes lines that another patch changes: join the two")
        result += lines[done:start] + new
        done, inserted_at = end, start
    return "".join(result + lines[done:])


def _mend(patch: Path) -> str:
    name = names_of(patch)[0]
    return (
        f"`tools/scripts/planted.py edit {name}` has its files in {EDITED}: put the fault in there,"
        f" then `tools/scripts/planted.py record {name}`\n"
    )


def copy(folder: Path) -> None:
    """Leaves alone what is right already, so that no more is built again than has changed."""
    with_faults = patched(patches())
    (folder / HOOKED).mkdir(parents=True, exist_ok=True)
    for entry in ROOT.iterdir():
        if entry.name not in NOT_LINKED and not entry.name.startswith("."):
            _link(folder / entry.name, entry)
    sources = [path for path in (ROOT / HOOKED).rglob("*") if path.is_file()]
    wanted = {folder / path.relative_to(ROOT): path for path in sources}
    for old in (folder / HOOKED).rglob("*"):
        if not old.is_dir() and old not in wanted:
            old.unlink()
    for file, source in wanted.items():
        file.parent.mkdir(parents=True, exist_ok=True)
        text = with_faults.get(source.relative_to(ROOT).as_posix())
        if text is None:
            _link(file, source)
        elif file.is_symlink() or not file.is_file() or file.read_text("utf-8") != SWITCH + text:
            file.unlink(missing_ok=True)
            file.write_text(SWITCH + text, encoding="utf-8")


def _link(path: Path, to: Path) -> None:
    if not path.is_symlink() or path.readlink() != to:
        path.unlink(missing_ok=True)
        path.symlink_to(to)


def patch_of(fault: str) -> Path:
    for patch in patches():
        if fault in (*names_of(patch), f"{patch.parent.name}/{patch.stem}"):
            return patch
    if "/" not in fault:
        raise Misfit(f"there is no fault {fault}; a new one is named with its folder, plane/NAME")
    return ROOT / PATCHES / f"{fault}.patch"


def edit(fault: str, files: list[str]) -> None:
    patch = patch_of(fault)
    misfits: list[Misfit] = []
    texts = patched([patch] if patch.is_file() else [], left_out=misfits)
    for file in files:
        texts.setdefault(file, "".join(lines_of(ROOT / file)))
    for file, text in texts.items():
        to = ROOT / EDITED / patch.stem / file
        to.parent.mkdir(parents=True, exist_ok=True)
        to.write_text(text, encoding="utf-8")
        print(to.relative_to(ROOT))
    for misfit in misfits:
        print(f"to be put in by hand: {misfit}")


def record(fault: str, what: str) -> None:
    patch = patch_of(fault)
    texts = described(patch) if patch.is_file() else {}
    head = [f"{name}: {what or texts.get(name, '')}\n" for name in names_of(patch)]
    folder = ROOT / EDITED / patch.stem
    edited = sorted(path for path in folder.rglob("*") if path.is_file())
    if not edited:
        raise Misfit(f"`tools/scripts/planted.py edit {fault}` comes first")
    text = "".join((*head, "\n", *(line for path in edited for line in _diff(path, folder))))
    patch.parent.mkdir(exist_ok=True)
    patch.write_text(text, encoding="utf-8")
    patched(patches())
    shutil.rmtree(folder)  # later it would be one of other sources
    print(patch.relative_to(ROOT))


def _diff(path: Path, folder: Path) -> Iterator[str]:
    name = path.relative_to(folder).as_posix()
    return difflib.unified_diff(lines_of(ROOT / name), lines_of(path), f"a/{name}", f"b/{name}")


def main(words: list[str]) -> int:
    try:
        match words:
            case ["copy", folder]:
                copy(Path(folder).resolve())
            case ["edit", fault, *files]:
                edit(fault, files)
            case ["record", fault, *what]:
                record(fault, " ".join(what))
            case _:
                print(__doc__, file=sys.stderr)
                return 2
    except Misfit as misfit:
        print(misfit, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
