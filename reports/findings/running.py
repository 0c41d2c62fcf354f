"""Runs the program of a finding with the installed library: `still`, `mended`, or `absent`.

A program ends with 0 if the library is right about the case, with 1 or by a signal if the fault
still shows; any other end is a fault of ours. Programs in C++ and Rust are compiled first; one
binary, which is kept, serves all findings of its program.
"""

from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

from minkref.errors import Refusal
from minkref.fuzz.isolation.own_folders import adapters_folder
from minkref.fuzz.libraries import catalogue, installation
from minkref.reports.findings.command import FLAGS, arguments, libraries
from minkref.reports.findings.entry import Entry

STILL, MENDED, ABSENT = "still", "mended", "absent"
SECONDS = 600
COMPILED = (".cpp", ".rs")
BROKEN = ("Traceback", "ERR_MODULE_NOT_FOUND", "error: ")  # the program itself


@dataclass(frozen=True)
class Ran:
    state: str
    said: str


def ran(entry: Entry, compiling: bool = True) -> Ran:
    """Without `compiling`, a program to compile runs only if its binary is kept. Raises Refusal if
    the program neither shows the fault nor passes."""
    named = catalogue.is_named(entry.adapter)  # CGAL's methods need its headers only
    reason = catalogue.absence(entry.adapter) if named else None
    to_compile = entry.path.suffix in COMPILED and not _kept(entry).is_file()
    if reason is None and to_compile and not compiling:
        reason = "its program has to be compiled"
    if reason is not None:
        return Ran(ABSENT, reason)
    home = adapters_folder() / (catalogue.adapter_named(entry.adapter).home if named else "")
    with tempfile.TemporaryDirectory() as folder:
        try:
            words = _words(entry, home, Path(folder))
            if words is None:
                return Ran(ABSENT, "there is no compiler, or the library's headers are missing")
            words += arguments(entry)
            done = subprocess.run(
                words, cwd=folder, capture_output=True, text=True, timeout=SECONDS, check=False
            )
        except subprocess.TimeoutExpired:
            return Ran(ABSENT, f"no end in {SECONDS} s")
    said = (done.stdout + done.stderr).strip()
    if done.returncode < 0 or done.returncode >= 128:
        return Ran(STILL, f"{said}\nit was ended by a signal".strip())
    if done.returncode in (0, 1) and not any(word in said for word in BROKEN):
        return Ran(STILL if done.returncode else MENDED, said)
    mend = "run the program by hand"
    raise Refusal(f"exit code {done.returncode}: {said[-800:]}", entry.program, mend)


def _words(entry: Entry, home: Path, folder: Path) -> list[str] | None:
    suffix = entry.path.suffix
    if suffix == ".py":
        return [str(installation.interpreter(home)), str(entry.path)]
    if suffix == ".scad":
        return ["openscad", "-o", str(folder / "out.svg"), str(entry.path)]
    if suffix == ".java":
        return ["java", "-cp", f"{home / 'jars'}/*", str(entry.path)]
    if suffix == ".mjs":
        shutil.copy(entry.path, folder)
        (folder / "node_modules").symlink_to(home / "node_modules")
        return ["node", str(folder / entry.program)]
    compiled = _compiled(entry, home, folder)
    return None if compiled is None else [str(compiled)]


def _kept(entry: Entry) -> Path:
    text = entry.path.read_bytes()
    return adapters_folder() / "findings" / hashlib.sha256(text).hexdigest()[:16]


def _compiled(entry: Entry, home: Path, folder: Path) -> Path | None:
    """The binary, kept for the same text."""
    kept = _kept(entry)
    if kept.is_file():
        return kept
    kept.parent.mkdir(parents=True, exist_ok=True)
    made = folder / "program"
    if entry.path.suffix == ".rs":
        if shutil.which("cargo") is None:
            return None
        shutil.copy(entry.path, folder / "adapter.rs")
        for name in ("Cargo.toml", "Cargo.lock"):
            shutil.copy(home / name, folder)
        words = ["cargo", "build", "--release", "--locked", "--quiet"]
        made = folder / "target" / "release" / "adapter"
    else:
        compiler = shutil.which("g++") or shutil.which("c++")
        if compiler is None:
            return None
        words = [compiler, *FLAGS, "-w", str(entry.path), "-o", str(made), *libraries(entry)]
    done = subprocess.run(
        words, cwd=folder, capture_output=True, text=True, timeout=SECONDS, check=False
    )
    if "No such file or directory" in done.stderr:
        return None
    if done.returncode:
        raise Refusal(done.stderr[-800:], entry.program, "see what the compiler says")
    part = kept.with_name(f"{kept.name}.{os.getpid()}")
    shutil.copy(made, part)
    part.replace(kept)
    return kept
