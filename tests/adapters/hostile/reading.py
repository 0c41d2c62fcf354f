"""Runs a command on a hostile file, and tells faults of its ending."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import threading
import unicodedata
from dataclasses import dataclass
from pathlib import Path

import outside

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER / "files"))

from hostile_file import STATE, Hostile  # noqa: E402 it lies beside

MOST_BYTES = 3 << 30  # of memory, in one process
PATIENCE = 300.0  # seconds, on a busy machine
LONGEST = 4000  # characters of a refusal
PARTING = ("\u202a", "\u202b", "\u202d", "\u202e", "\u2066", "\u2067", "\u2068")


@dataclass
class Read:
    title: str
    code: int | None
    seconds: float  # of a processor
    peak_bytes: int
    told: str
    faults: list[str]


def read(hostile: Hostile) -> Read:
    """Runs the command in an empty folder; the file lies in another."""
    base = Path(tempfile.mkdtemp(prefix="minkref-evidence-"))
    try:
        work, files, home, temporary = (base / name for name in ("work", "files", "home", "tmp"))
        for folder in (work, files, home, temporary):
            folder.mkdir()
        path = hostile.make(files)
        before = stamp(path)
        kept = base / "kept"
        command = [sys.executable, "-m", "minkref", *hostile.words(path)]
        environment = {**os.environ, **STATE, "HOME": str(home), "TMPDIR": str(temporary)}
        environment |= {k: v.replace("{}", str(path)) for k, v in hostile.environment.items()}
        during = threading.Thread(target=hostile.during, args=(path,), daemon=True)
        if hostile.during:
            during.start()
        parent = [sys.executable, str(FOLDER / "supervisor.py"), str(kept), str(PATIENCE), "memory"]
        subprocess.run([*parent, "--", *command], cwd=work, env=environment, check=True)
        if hostile.during:
            during.join(10)
        told = json.loads(kept.read_text())
        text = "".join(
            Path(f"{kept}.{stream}").read_text(errors="surrogateescape")
            for stream in ("stdout", "stderr")
        )
        faults = faults_of(hostile, told, text)
        refused = told["code"] == 2
        if refused and any(work.iterdir()):
            faults.append(f"something was written: {sorted(os.listdir(work))[:3]}")
        if any(temporary.iterdir()):
            faults.append(f"temporary files are left: {sorted(os.listdir(temporary))[:3]}")
        if refused and not hostile.during and stamp(path) != before:
            faults.append("the file was changed")
        return Read(
            hostile.title, told["code"], told["cpu_seconds"], told["peak_bytes"], text[:500], faults
        )
    finally:
        outside.remove_folder(base)


def stamp(path: Path) -> tuple[int, int, int] | None:
    if not os.path.lexists(path) or path.is_dir():
        return None
    status = path.lstat()
    return status.st_size, status.st_mtime_ns, status.st_mode


def faults_of(hostile: Hostile, told: dict[str, object], text: str) -> list[str]:
    faults = []
    code = told["code"]
    used = told["cpu_seconds"]
    if code is None or (isinstance(used, float) and used > hostile.seconds):
        faults.append(f"no end within {hostile.seconds} s")
    elif code not in hostile.codes:
        faults.append(f"exit code {code}")
    if told["left"]:
        faults.append(f"processes are left: {told['left']}")
    if "Traceback" in text:
        faults.append("a traceback")
    if isinstance(peak := told["peak_bytes"], int) and peak > MOST_BYTES:
        faults.append(f"{peak >> 20} MiB of memory")
    if code == 2:
        if len(text) > LONGEST:
            faults.append(f"a message of {len(text)} characters")
        if "fix:" not in text and hostile.command[0] != "check":
            faults.append("no mend")
    if bad := sorted({repr(letter) for letter in text if obeyed(letter)}):
        faults.append(f"letters that a terminal obeys: {' '.join(bad)}")
    return faults


def obeyed(letter: str) -> bool:
    if letter in "\n\t":
        return False
    return unicodedata.category(letter) in ("Cc", "Cs") or letter in PARTING
