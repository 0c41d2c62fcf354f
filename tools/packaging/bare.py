"""Runs every command of a wheel on a bare machine: no compiler, no headers, no GMP, no network.

bare.py WHEEL [--python PYTHON] [--quick] [--figures FILE]: installs WHEEL, without and then with
its extras, into an environment of its own, and runs the commands of bare_commands.py in a root that
holds nothing else (bare_root.py). Exit code 1 where one of them does not do what it should; the
figures, as JSON, go to FILE. --quick leaves out what takes long.
"""

from __future__ import annotations

import argparse
import json
import re
import subprocess
import sys
import sysconfig
import tempfile
import time
from pathlib import Path

from bare_commands import FUNCTIONS, STEPS, Step, words_of
from bare_root import BareRoot

ROOT = Path(__file__).resolve().parents[2]
EXTRAS = sorted({step.extra for step in STEPS if step.extra})
LIMIT = 300.0  # seconds of one command
HAS = "from minkref.cli.command_group import COMMANDS; print(*COMMANDS)"
WHERE = "import minkref._core as core; print(core.__file__)"


class BareMachine:
    """A wheel in a separate root, and results of commands there."""

    def __init__(self, folder: Path, wheel: Path, python: str) -> None:
        self.wheel, self.environment, self.work = wheel, folder / "minkref", folder / "home"
        self.work.mkdir()
        (self.work / "functions.py").write_text(FUNCTIONS, encoding="utf-8")
        self.uv("venv", "--python", python, str(self.environment))
        self.install()
        self.root = BareRoot(self.environment, self.work)
        self.rows: list[dict[str, object]] = []

    def uv(self, *words: str) -> None:
        command = [
            str(Path(sysconfig.get_path("scripts"), "uv")),
            *words,
            "--quiet",
            "--system-certs",
        ]
        subprocess.run(command, check=True)

    def install(self, *extras: str) -> None:
        """Installs the wheel with its requirements, at the versions of requirements.txt."""
        asked = f"{self.wheel}[{','.join(extras)}]" if extras else str(self.wheel)
        pinned = ("--constraint", str(ROOT / "requirements.txt"))
        self.uv("pip", "install", "--python", str(self.environment), *pinned, asked)

    def python(self, code: str) -> str:
        words = self.root.command(str(self.environment / "bin" / "python"), "-c", code)
        return subprocess.run(words, check=True, capture_output=True, text=True).stdout.strip()

    def run(self, step: Step, refused: bool = False) -> None:
        """Runs a step and notes its faults. If `refused`, the step's extra is absent: the command
        must exit with 2 and name the extra."""
        program = str(self.environment / "bin" / "minkref")
        began = time.monotonic()
        done = subprocess.run(
            self.root.command(program, *words_of(step)),
            capture_output=True, text=True, timeout=LIMIT, stdin=subprocess.DEVNULL,
        )  # fmt: skip
        seconds = time.monotonic() - began
        said = done.stdout + done.stderr
        code, says = (2, f"minkref[{step.extra}]") if refused else (step.code, step.says)
        faults = [f"exit code {done.returncode}, not {code}"] if done.returncode != code else []
        if says not in said:
            faults.append(f"{says!r} is not said")
        files = () if refused else step.files
        faults += [f"no file {name}" for name in files if not (self.work / name).is_file()]
        line = "minkref " + " ".join(step.words) + (" (without its extra)" if refused else "")
        self.note(line, seconds, faults)
        if faults:
            print("\n".join(f"    | {text}" for text in said.splitlines()[-20:]))

    def note(self, line: str, seconds: float, faults: list[str]) -> None:
        self.rows.append({"line": line, "seconds": round(seconds, 2), "faults": faults})
        print(
            f"{seconds:6.1f} s  {line}" + "".join(f"\n    {fault}" for fault in faults), flush=True
        )

    def replace_gmp(self) -> None:
        """Replaces the wheel's GMP by another, as the LGPL allows, and checks that the wheel uses
        the replacement."""
        (inside,) = self.environment.glob("lib/python*/site-packages/minkref.libs/libgmp-*")
        kept = inside.read_bytes()
        began, faults = time.monotonic(), []
        inside.write_bytes(b"no library")
        program = self.root.command(str(self.environment / "bin" / "minkref"), "models")
        if subprocess.run(program, capture_output=True).returncode == 0:
            faults.append("the library in the wheel is not the one that is used")
        inside.write_bytes(Path(system_gmp()).read_bytes())
        program = self.root.command(str(self.environment / "bin" / "minkref"), "sum", "g1", "g2")
        if subprocess.run(program, capture_output=True).returncode:
            faults.append("another library in its place does not work")
        inside.write_bytes(kept)
        self.note("another GMP in place of the wheel's", time.monotonic() - began, faults)


def system_gmp() -> str:
    said = subprocess.run(["/sbin/ldconfig", "-p"], capture_output=True, text=True).stdout
    found = re.search(r"libgmp\.so\.10 \(libc6,\S+\) => (\S+)", said)
    if found is None:
        sys.exit("minkref: this machine has no GMP to put in the place of the wheel's")
    return found[1]


def run_all(machine: BareMachine, quick: bool) -> None:
    unwanted = machine.root.unwanted()
    machine.note("nothing in the root but Python and the wheel", 0.0, unwanted)
    core = machine.python(WHERE)
    outside = [] if core.startswith(f"{machine.environment}/") else [f"it is {core}"]
    machine.note("the extension module is the wheel's", 0.0, outside)
    typed = {step.words[0] for step in STEPS}
    lacking = [name for name in machine.python(HAS).split() if name not in typed]
    machine.note("each command is tried", 0.0, [f"{name} is not" for name in lacking])
    steps = [step for step in STEPS if not (quick and step.slow)]
    for step in steps:
        machine.run(step, refused=bool(step.extra) and not step.optional)
    machine.replace_gmp()
    machine.install(*EXTRAS)
    for step in steps:
        if step.extra:
            machine.run(step)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("wheel", type=Path)
    parser.add_argument("--python", default=sys.executable)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--figures", type=Path)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="minkref-bare-") as folder:
        machine = BareMachine(Path(folder), options.wheel.resolve(), options.python)
        run_all(machine, options.quick)
    faults = sum(bool(row["faults"]) for row in machine.rows)
    print(f"{len(machine.rows) - faults} passed, {faults} failed")
    if options.figures:
        options.figures.write_text(json.dumps(machine.rows, indent=1) + "\n", encoding="utf-8")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
