"""libFuzzer targets: built with clang and its sanitizers, and run for a time."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import time
from dataclasses import dataclass
from pathlib import Path

from minkref.reports.evidence.framework.places import FOLDER, ROOT

PACKAGES = ("clang", "libclang-rt-14-dev")  # of Debian
OPTIONS = (
    "-DMINKREF_FUZZ=ON",
    "-DMINKREF_CGAL=OFF",
    "-DMINKREF_CHECKER=OFF",
    "-DMINKREF_SAMPLED=OFF",
    "-DMINKREF_BOOST=OFF",
    "-DMINKREF_PYTHON=OFF",
    "-DMINKREF_TESTS=OFF",
    "-DCMAKE_BUILD_TYPE=RelWithDebInfo",
    "-DCMAKE_CXX_COMPILER=clang++",
)


@dataclass(frozen=True)
class Fuzzed:
    """A fuzz target's result. `findings` are names of artifacts left behind."""

    target: str
    code: int
    seconds: float
    edges: int
    findings: list[str]
    log: str

    @property
    def clean(self) -> bool:
        return self.code == 0 and not self.findings


def has_fuzzer() -> bool:
    """Whether clang exists, with its sanitizer and libFuzzer libraries."""
    source = 'extern "C" int LLVMFuzzerTestOneInput(const char*, unsigned long) { return 0; }'
    flags = ["-fsanitize=fuzzer,address,undefined", "-x", "c++", "-", "-o", "/dev/null"]
    if shutil.which("clang++") is None:
        return False
    return subprocess.run(["clang++", *flags], input=source.encode()).returncode == 0


def build(folder: Path, below: str, *arguments: str, target: str = "all") -> list[Path]:
    """Configures and builds in `folder`; returns the executables `fuzz_*` from the path `below`."""
    if not has_fuzzer():
        subprocess.run(["tools/scripts/require_packages.sh", *PACKAGES], cwd=ROOT, check=True)
    configure = ["cmake", "-S", str(ROOT), "-B", str(folder), "-G", "Ninja", *OPTIONS, *arguments]
    subprocess.run(configure, check=True)
    make = ["cmake", "--build", str(folder), "-j", "2", "--target", target]
    subprocess.run(make, check=True)
    found = sorted(
        path
        for path in (folder / below).glob("fuzz_*")
        if path.is_file() and os.access(path, os.X_OK)
    )
    if not found:
        raise RuntimeError(f"no fuzz target was built in {folder / below}")
    return found


def fuzz(target: Path, seconds: int, corpus: Path, seeds: Path, *flags: str) -> Fuzzed:
    """Runs a target for so many seconds, starting from its seeds, if any, and from earlier finds
    (`corpus`)."""
    corpus.mkdir(parents=True, exist_ok=True)
    artifacts = FOLDER / "fuzzing" / target.name
    shutil.rmtree(artifacts, ignore_errors=True)
    artifacts.mkdir(parents=True)
    command = [str(target), str(corpus), *([str(seeds)] if seeds.is_dir() else []), *flags]
    command += [f"-max_total_time={seconds}", "-print_final_stats=1"]
    command += [f"-artifact_prefix={artifacts}/"]
    began = time.monotonic()
    log = artifacts / "log.txt"
    with open(log, "w", encoding="utf-8") as out:
        code = subprocess.run(
            command, stdout=out, stderr=out, timeout=10 * seconds + 300, cwd=artifacts
        ).returncode
    spent = time.monotonic() - began
    text = log.read_text(encoding="utf-8", errors="replace")
    covered = re.findall(r"cov: (\d+)", text)
    left = [path.name for path in artifacts.iterdir() if path != log]
    edges = int(covered[-1]) if covered else 0
    return Fuzzed(target.name, code, spent, edges, left, text)
