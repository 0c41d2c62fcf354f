"""build.sh of OSS-Fuzz and ClusterFuzzLite, run as their images run it: one target is built from a
copy of the sources, with seeds, dictionary and options, and runs on its seeds and beyond."""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
import zipfile
from pathlib import Path

from minkref.reports.evidence.framework.libfuzzer import has_fuzzer
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.framework.places import FOLDER, ROOT

RESTS_ON = (".clusterfuzzlite/", "CMakeLists.txt", "formats/", "tests/fuzzing/")
MINUTES = Minutes(None, 3, 4)  # it builds

TARGET = "fuzz_wkt"
SECONDS = Counts(0, 5, 60)
SOURCES = (
    "CMakeLists.txt",
    "pyproject.toml",
    ".clusterfuzzlite",
    "reference",
    "formats",
    "tests",
    "tools",
)
BUILT = ROOT / "build" / "release" / "reference" / "libminkref_reference.a"
SANITIZERS = "-O0 -fsanitize=address,undefined -fno-sanitize-recover=all"
ENGINE = ROOT / "tests" / "fuzzing" / "plain_engine.cpp"


def run(findings: Findings, size: Size) -> None:
    FOLDER.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=FOLDER) as name:
        out = _built(findings, Path(name))
        seeds = {path.name for path in (ROOT / "tests/fuzzing/corpus/wkt").iterdir()}
        with zipfile.ZipFile(out / f"{TARGET}_seed_corpus.zip") as archive:
            findings.equal("seeds in the archive", sorted(seeds), sorted(archive.namelist()))
            archive.extractall(out / "seeds")
        for ending in (".options", ".dict"):
            there = (out / f"{TARGET}{ending}").is_file()
            findings.law(f"{TARGET}{ending}", there, "there", "there" if there else "missing")
        seconds = size.of(SECONDS)
        words = [f"-max_total_time={seconds}", "-max_len=4096", "-timeout=20", "-seed=1", "seeds"]
        ran = subprocess.run(
            [str(out / TARGET), *words], cwd=out, capture_output=True, text=True, timeout=600
        )
        said = (ran.stdout + ran.stderr).strip().splitlines()
        findings.law("exit code of the target", not ran.returncode, 0, ran.returncode)
        findings.figures = {"target": TARGET, "seconds": seconds, "said": said[-1:]}


def _built(findings: Findings, folder: Path) -> Path:
    """Runs build.sh with the variables of the images; returns OUT."""
    source, out, work = folder / "src", folder / "out", folder / "work"
    for each in (source / "minkref", out, work):
        each.mkdir(parents=True)
    for name in SOURCES:
        copy = shutil.copytree if (ROOT / name).is_dir() else shutil.copy
        copy(ROOT / name, source / "minkref" / name)
    compilers, engine = ("clang", "clang++"), "-fsanitize=fuzzer"
    flags = f"{SANITIZERS} -fsanitize=fuzzer-no-link"
    if not has_fuzzer():
        findings.note("There is no clang: g++ builds, with an engine that follows no coverage.")
        compilers, engine, flags = ("gcc", "g++"), str(work / "engine.o"), SANITIZERS
        compile_engine = ["g++", "-std=c++20", "-O1", "-c", str(ENGINE), "-o", engine]
        subprocess.run(compile_engine, check=True)
    variables = {
        "CC": compilers[0],
        "CXX": compilers[1],
        "CFLAGS": flags,
        "CXXFLAGS": flags,
        "LIB_FUZZING_ENGINE": engine,
        "SRC": str(source),
        "OUT": str(out),
        "WORK": str(work),
        "MINKREF_FUZZ_TARGETS": TARGET,
        "MINKREF_REFERENCE_ARCHIVE": str(BUILT),
    }
    script = source / "minkref" / ".clusterfuzzlite" / "build.sh"
    subprocess.run([str(script)], env={**os.environ, **variables}, check=True)
    return out
