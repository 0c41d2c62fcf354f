"""The trial of doubles (float_trial.cpp), compiled as people compile what includes us."""

from __future__ import annotations

import shutil
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

from minkref.reports.evidence.framework.places import ROOT

TRIAL = "reference/paper/trials/float_trial.cpp"
LIBRARY = ROOT / "build" / "release" / "reference" / "libminkref_reference.a"
UNSAFE = 3  # the trial's exit code when the library refuses to compute

# By compiler. gcc's last flags leave a program that flushes subnormal numbers from the start.
TAKEN = {
    "g++": (
        ("-O0",),
        ("-O3", "-march=native", "-ffp-contract=fast"),
        ("-O2", "-flto"),
        ("-O2", "-frounding-math"),
        ("-O2", "-fno-signed-zeros", "-fno-trapping-math", "-fno-math-errno"),
        ("-O2", "LINK:-ffast-math"),
    ),
    # Without optimization, -freciprocal-math changes nothing.
    "clang++": (
        ("-O0",),
        ("-O0", "-freciprocal-math"),
        ("-O2",),
        ("-O3", "-march=native", "-ffp-contract=fast"),
    ),
}
REFUSED = {
    "g++": (
        ("-O2", "-ffast-math"),
        ("-Ofast",),
        ("-O2", "-funsafe-math-optimizations"),
        ("-O2", "-fassociative-math", "-fno-signed-zeros", "-fno-trapping-math"),
        ("-O2", "-freciprocal-math"),
        ("-O2", "-ffinite-math-only"),
        ("-O2", "-mfpmath=387"),
        ("-O2", "-fsingle-precision-constant"),
    ),
    "clang++": (
        ("-O2", "-ffast-math"),
        ("-Ofast",),
        ("-O2", "-ffinite-math-only"),
        ("-O2", "-funsafe-math-optimizations"),
        ("-O2", "-fassociative-math", "-fno-signed-zeros", "-fno-trapping-math"),
        ("-O2", "-fno-honor-nans"),
        ("-O2", "-fno-honor-infinities"),
        ("-O2", "-freciprocal-math"),
    ),
}


@dataclass(frozen=True)
class Tried:
    """`compiled`: whether the compiler succeeded; `code`: the exit code; `counts`: tries and errors
    for each checked thing."""

    compiled: bool
    code: int = -1
    counts: dict[str, tuple[int, int]] | None = None
    told: str = ""

    @property
    def tried(self) -> int:
        return sum(tried for tried, _ in (self.counts or {}).values())

    @property
    def is_refused(self) -> bool:
        """Whether the compiler or the running program refuses with an explanation."""
        if not self.compiled:
            return "minkref needs" in self.told
        return self.code == UNSAFE and "cannot compute exactly" in self.told


def compilers() -> list[str]:
    """Those that are here."""
    return [name for name in TAKEN if shutil.which(name) is not None]


def trial(compiler: str, flags: tuple[str, ...], seed: int, count: int) -> Tried:
    """Compiles the trial with these flags, and runs it for so many rounds."""
    link = [flag.removeprefix("LINK:") for flag in flags if flag.startswith("LINK:")]
    compile_flags = [flag for flag in flags if not flag.startswith("LINK:")]
    with tempfile.TemporaryDirectory(prefix="minkref-") as folder:
        unit, program = Path(folder, "trial.o"), Path(folder, "trial")
        made = subprocess.run(
            [
                compiler, "-std=c++20", f"-I{ROOT}", "-isystem", "/usr/include/eigen3",
                *compile_flags, "-c", str(ROOT / TRIAL), "-o", str(unit),
            ],
            capture_output=True, text=True, check=False,
        )  # fmt: skip
        if made.returncode != 0:
            return Tried(False, told=made.stderr)
        parts = [str(unit), str(LIBRARY), "-lmpfr", "-lgmp", "-lpthread"]
        subprocess.run([compiler, *compile_flags, *link, *parts, "-o", str(program)], check=True)
        ran = subprocess.run(
            [program, str(seed), str(count)], capture_output=True, text=True, check=False
        )
    counts = {}
    for line in ran.stdout.splitlines():
        what, tried, wrong = line.split("\t")
        counts[what] = int(tried), int(wrong)
    return Tried(True, ran.returncode, counts, ran.stderr)
