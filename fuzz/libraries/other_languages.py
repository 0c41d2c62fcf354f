"""Adapters in JavaScript, Java and Rust: what each needs, how it gets into its folder, and starts.

Libraries are pinned by digest in files beside the program: package-lock.json, jars.txt, Cargo.lock.
Program and loop are copied beside the libraries.
"""

from __future__ import annotations

import hashlib
import os
import shutil
import urllib.request
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from minkref.errors import Refusal

CENTRAL = "https://repo1.maven.org/maven2"  # MAVEN_CENTRAL names a mirror
SECONDS = 120.0
Run = Callable[[list[str], str], None]


@dataclass(frozen=True)
class Language:
    """`start`: a file in the adapter's folder. `pins`: files beside the program. `loop`: files from
    fuzz/adapters. `tool` installs; Debian has it in `packages`. `asked`: installed by name only."""

    start: str
    pins: tuple[str, ...]
    loop: tuple[str, ...]
    tool: str
    packages: str
    words: tuple[str, ...] = ()
    asked: bool = True


LANGUAGES = {
    "node": Language(
        "adapter.mjs",
        ("package.json", "package-lock.json"),
        ("adapter_protocol.mjs",),
        "npm",
        "nodejs npm",
        ("node",),
        asked=False,
    ),
    "java": Language(
        "Adapter.class",
        ("jars.txt",),
        (),
        "javac",
        "default-jdk-headless",
        ("java", "-Xmx1g", "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1"),
    ),
    "rust": Language(
        "adapter", ("Cargo.toml", "Cargo.lock"), ("adapter_protocol.rs",), "cargo", "cargo"
    ),
}


def missing_tool(kind: str) -> str | None:
    """Names a missing program and the command to get it; else None."""
    language = LANGUAGES[kind]
    if shutil.which(language.tool):
        return None
    return f"{language.tool} was not found: apt-get install -y {language.packages} (as root)"


def sources(kind: str, program: Path, loops: Path) -> list[Path]:
    """The files that an installation depends on."""
    language = LANGUAGES[kind]
    beside = [program.with_name(name) for name in language.pins]
    return [*beside, program, *(loops / name for name in language.loop)]


def start(kind: str, home: Path) -> list[str]:
    language = LANGUAGES[kind]
    if kind == "java":
        return [*language.words, "-cp", f"{home}:{home / 'jars'}/*", "Adapter"]
    return [*language.words, str(home / language.start)]


def make(kind: str, home: Path, program: Path, loops: Path, run: Run) -> None:
    """Fills `home`. Raises Refusal if a tool or a library is missing, or a digest differs."""
    missing = missing_tool(kind)
    if missing is not None:
        what, mend = missing.split(": ", 1)
        raise Refusal(what, home.name, mend, "not-installed")
    for path in sources(kind, program, loops):
        shutil.copy(path, home / path.name)
    {"node": _node, "java": _java, "rust": _rust}[kind](home, run)


def _node(home: Path, run: Run) -> None:
    words = ["npm", "--prefix", str(home), "ci", "--ignore-scripts", "--no-audit", "--no-fund"]
    words += ["--fetch-retries=1", "--fetch-retry-mintimeout=1000", "--fetch-timeout=60000"]
    run(words, "see what npm says; it needs a registry that it can reach")


def _java(home: Path, run: Run) -> None:
    (home / "jars").mkdir()
    for line in (home / "jars.txt").read_text(encoding="utf-8").splitlines():
        digest, path = line.split()
        _download(f"{os.environ.get('MAVEN_CENTRAL', CENTRAL)}/{path}", digest, home / "jars")
    words = ["javac", "-cp", f"{home / 'jars'}/*", "-d", str(home), str(home / "Adapter.java")]
    run(words, "see what javac says; it needs Java 17")


def _download(address: str, digest: str, folder: Path) -> None:
    try:
        with urllib.request.urlopen(address, timeout=SECONDS) as answer:
            content: bytes = answer.read()
    except OSError as error:
        mend = "MAVEN_CENTRAL names a mirror that can be reached"
        raise Refusal(str(error), address, mend, "not-installed") from error
    if hashlib.sha256(content).hexdigest() != digest:
        raise Refusal("its digest is another", address, "try again; do not use it", "not-installed")
    (folder / address.rpartition("/")[2]).write_bytes(content)


def _rust(home: Path, run: Run) -> None:
    target = home / "target"
    words = ["cargo", "build", "--release", "--locked", "--quiet"]
    words += ["--manifest-path", str(home / "Cargo.toml"), "--target-dir", str(target)]
    run(words, "see what cargo says; it needs Rust 1.88 and a registry that it can reach")
    shutil.copy(target / "release" / "adapter", home / "adapter")
    shutil.rmtree(target)
