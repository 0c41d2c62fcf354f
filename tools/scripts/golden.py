#!/usr/bin/env python3
"""The golden record: what the program says to thousands of questions, so that a change of the house
is seen to change no answer.

golden.py record FOLDER [PART...]: asks, and writes a file for each part into the folder.
golden.py compare FOLDER [PART...]: asks again, prints what differs, and exits with 1 if something
does. Only commands are called, and nothing is known of modules: those may move between the two.
Console blocks of the docs are tests: tests/docs compares them with what commands print.

What depends on time and machine is left out: seconds, memory, versions, names of folders.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import multiprocessing
import os
import re
import sys
import tempfile
import tomllib
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any, NoReturn

ROOT = Path(__file__).resolve().parents[2]
CORPUS = ROOT / "degeneracies" / "corpus"
FULL = 400  # characters of a text that are kept; of a longer one a digest
SCALES = 1  # of each case
ROUTES = {2: ("paper", "winding", "definition", "index"), 3: ("edges", "definition")}
SEEDS, PAIRS = (1, 2, 3, 4, 5), 200
JUDGED = ("minkref", "minkref:paper", "minkref:winding", "minkref:definition")
CHANGES = 12  # of each certificate of the corpus
CHANGED = 40  # certificates
CERTIFIED = 50  # cases whose certificate is made
CHECKERS = {  # programs that need nothing of the package
    "minkref-check": ("build/release/oracle/checker/minkref-check",),
    "check.py": (sys.executable, "oracle/checker/check.py"),
    "minkref-check-proved": ("build/proofs/minkref-check-proved",),
}
VARIES = re.compile(  # signs that doubles settle are counted by threads that share work
    "second|peak|memory|version|commit|date$|machine|^ms$|_ms$|milli|micro"
    "|^by_float$|^total$|^shares$|^spent$|^chain$"
)
IN_TEXT = re.compile(r"\d[\d.,]* ?(?:s|ms|µs|ns|[KMG]i?B)\b|0\.\d+\.\d+\S*")


@dataclass(frozen=True)
class Question:
    """A command of minkref, or a program by its whole path, in an empty folder with these files."""

    key: str
    words: tuple[str, ...]
    files: tuple[tuple[str, str], ...] = ()


def answer(question: Question, loaded: Path | None = None) -> tuple[str, str]:
    """Asks in a separate process: the output, and digests of the files written. `loaded` receives
    the names of the modules needed."""
    with (
        tempfile.TemporaryDirectory() as name,
        tempfile.TemporaryFile() as out,
        tempfile.TemporaryFile() as warned,
    ):
        folder = Path(name)
        for file, text in question.files:
            (folder / file).write_text(text, encoding="utf-8")
        child = os.fork()
        if child == 0:
            _become(question.words, folder, (out.fileno(), warned.fileno()), loaded)
        _, status = os.waitpid(child, 0)
        texts = []
        for stream in (out, warned):
            stream.seek(0)
            texts.append(stream.read().decode(errors="replace").replace(name, "FOLDER"))
        given = {file for file, _ in question.files}
        written = [
            f"{path.relative_to(folder)} {of_file(path)}"
            for path in sorted(folder.rglob("*"))
            if path.is_file() and str(path.relative_to(folder)) not in given
        ]
    rows = [
        f"exit code {os.waitstatus_to_exitcode(status)}",
        short(masked(texts[0])),
        short(IN_TEXT.sub("#", texts[1])),
        *written,
    ]
    return question.key, "\n".join(rows)


def _become(
    words: tuple[str, ...], folder: Path, out: tuple[int, int], loaded: Path | None = None
) -> NoReturn:
    code = 99
    try:
        os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
        os.dup2(out[0], 1)
        os.dup2(out[1], 2)
        os.chdir(folder)
        os.environ.update(COLUMNS="100", TERM="dumb", NO_COLOR="1")
        os.environ.pop("MINKREF_MODELS", None)
        if os.path.isabs(words[0]):
            os.execv(words[0], words)
        sys.argv[:] = ["minkref", *words]
        sys.stdout, sys.stderr = (open(n, "w", encoding="utf-8", closefd=False) for n in (1, 2))
        program()()
    except SystemExit as end:
        code = end.code if isinstance(end.code, int) else 0 if end.code is None else 98
    finally:
        if loaded is not None:
            names = [name for name in sys.modules if name.startswith("minkref.")]
            loaded.write_text("\n".join(names), encoding="utf-8")
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(code)


def program() -> Any:
    """The function behind the command `minkref`, wherever defined."""
    told = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    module, _, name = told["project"]["scripts"]["minkref"].partition(":")
    return getattr(import_module(module), name)


def load(question: Question) -> None:
    """The modules that a question needs, once for all copies of this process."""
    with tempfile.TemporaryDirectory() as name:
        loaded = Path(name, "loaded")
        answer(question, loaded)
        for module in loaded.read_text(encoding="utf-8").split():
            import_module(module)


def masked(text: str) -> str:
    """Documents and ledgers without what varies, in order of keys; other text without seconds."""
    try:
        return json.dumps(_constant(json.loads(text)), sort_keys=True, ensure_ascii=False)
    except ValueError:
        lines = text.splitlines()
    if len(lines) > 1 and all(line.startswith("{") for line in lines):  # a ledger
        return "\n".join(masked(line) for line in lines)
    return IN_TEXT.sub("#", text)


def of_file(path: Path) -> str:
    """The digest of its bytes; a ledger holds seconds."""
    if path.suffix == ".jsonl":
        return digest(masked(path.read_text(encoding="utf-8")))
    return hashlib.sha256(path.read_bytes()).hexdigest()


def _constant(value: Any) -> Any:
    if isinstance(value, dict):
        return {k: _constant(v) for k, v in value.items() if not VARIES.search(k)}
    return [_constant(item) for item in value] if isinstance(value, list) else value


def digest(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()


def short(text: str) -> str:
    return text if len(text) <= FULL else f"{text[:FULL]}... {len(text)} {digest(text)}"


def commands(*group: str) -> Iterator[tuple[str, ...]]:
    """Lists all commands, including grouped ones, as --help does."""
    with tempfile.TemporaryFile() as out:
        if (child := os.fork()) == 0:
            _become((*group, "--help"), ROOT, (out.fileno(), out.fileno()))
        os.waitpid(child, 0)
        out.seek(0)
        text = out.read().decode()
    for title, body in re.findall(r"^╭─ (.*?) ─*╮$(.*?)^╰", text, re.M | re.S):
        if title not in ("Options", "Arguments"):
            for name in re.findall(r"^│ ([a-z][a-z-]*) {2,}", body, re.M):
                yield (*group, name)
                if not group:
                    yield from commands(name)


def cases() -> Iterator[tuple[str, Any]]:
    for path in sorted(CORPUS.glob("*/*.json")):
        if not path.name.endswith(".cert.json"):
            yield f"{path.parent.name}/{path.stem}", json.loads(path.read_text(encoding="utf-8"))


def helps() -> Iterator[Question]:
    for words in ((), *commands()):
        yield Question(f"{' '.join(words)} --help", (*words, "--help"))


def schemas() -> Iterator[Question]:
    for words in commands():
        yield Question(f"{' '.join(words)} --schema", (*words, "--schema"))


def sums() -> Iterator[Question]:
    """Questions for the sums of all cases by all routes."""
    for name, case in cases():
        files = tuple((f"{k}.json", json.dumps(case[k])) for k in "PQ")
        for scale in case["scales"][:SCALES]:
            scale = scale if isinstance(scale, str) else ",".join(scale)
            for route in ROUTES[case["dimension"]]:
                words = ("sum", "P.json", "Q.json", "--scale", scale, "--route", route, "--json")
                yield Question(f"{name} {scale} {route}", words, files)


def events() -> Iterator[Question]:
    """Questions for the events and the convolution of one case of each family."""
    seen = set()
    for name, case in cases():
        if case["dimension"] == 2 and (family := name.partition("/")[0]) not in seen:
            seen.add(family)
            files = tuple((f"{k}.json", json.dumps(case[k])) for k in "PQ")
            for verb in ("events", "convolution"):
                yield Question(f"{verb} {name}", (verb, "P.json", "Q.json", "--json"), files)


def made() -> Iterator[Question]:
    """A case of each family, made anew with its certificate, byte for byte."""
    for family in sorted({name.partition("/")[0] for name, _ in cases()} - {"found"}):
        yield Question(family, ("generate", family, "--index", "0", "--jobs", "1", "--json"))
    for family in ("disc", "paths", "invalid", "invalid-mesh"):
        words = ("generate", family, "--count", "1", "--jobs", "1", "--json")
        yield Question(family, words)


def certificates() -> Iterator[Question]:
    """Certificates of sums of cases, byte for byte."""
    every = list(cases())
    for name, case in every[:: max(1, len(every) // CERTIFIED)]:
        files = tuple((f"{k}.json", json.dumps(case[k])) for k in "PQ")
        scale = case["scales"][0]
        scale = scale if isinstance(scale, str) else ",".join(scale)
        words = ("certify", "P.json", "Q.json", "--scale", scale, "-o", "c.cert.json")
        yield Question(f"{name} {scale}", words, files)


def programs() -> Iterator[Question]:
    """The certificates of `checks`, separately for each checker built."""
    for name, (program, *rest) in CHECKERS.items():
        words = [str(ROOT / word) for word in (program, *rest)]
        if not all(Path(word).exists() for word in words):
            print(f"not built, not asked: {name}", file=sys.stderr)
            continue
        for question in checks():
            yield Question(f"{name} {question.key}", (*words, "c.cert.json"), question.files)


def checks() -> Iterator[Question]:
    """Certificates of the corpus, and the same with one digit changed."""
    every = sorted(CORPUS.glob("*/*.cert.json"))
    for path in every[:: max(1, len(every) // CHANGED)]:
        text = path.read_text(encoding="utf-8")
        case = path.with_name(path.name.replace(".cert.json", ".json"))
        files = ((case.name, case.read_text(encoding="utf-8")),)
        places = [found.start() for found in re.finditer(r"(?<=[\" -])\d", text)]
        step = max(1, len(places) // CHANGES)
        for k, place in enumerate([None, *places[::step]]):
            changed = text
            if place is not None:
                changed = f"{text[:place]}{(int(text[place]) + 1) % 10}{text[place + 1 :]}"
            words = ("check", "c.cert.json", "--json")
            yield Question(f"{path.stem} {k}", words, (*files, ("c.cert.json", changed)))


def verdicts() -> Iterator[Question]:
    """Ledgers of runs."""
    for seed in SEEDS:
        words = ("verify", *JUDGED, "--pairs", str(PAIRS), "--seed", str(seed), "--no-models")
        more = ("--jobs", "1", "--shrink-calls", "20", "--ledger", "run.jsonl", "--json")
        yield Question(f"seed {seed}", (*words, *more))


ALL = (helps, schemas, sums, events, made, certificates, checks, programs, verdicts)
PARTS = {part.__name__: part for part in ALL}


def ask(part: str) -> dict[str, str]:
    questions = list(PARTS[part]())
    if not os.path.isabs(questions[-1].words[0]):
        load(questions[-1])
    context = multiprocessing.get_context("fork")
    with ProcessPoolExecutor(os.cpu_count(), context) as pool:  # whose children may have children
        found: dict[str, str] = {}
        for number, (key, text) in enumerate(pool.map(answer, questions), 1):
            found[key] = text
            if sys.stderr.isatty():
                print(f"\r{part} {number} of {len(questions)}", end="", file=sys.stderr)
    return found


def main() -> int:
    parser = argparse.ArgumentParser(prog="golden.py", description=__doc__)
    parser.add_argument("verb", choices=("record", "compare"))
    parser.add_argument("folder", type=Path)
    parser.add_argument("parts", nargs="*", metavar="PART", help=f"of {', '.join(PARTS)}")
    options = parser.parse_args()
    unknown = set(options.parts) - set(PARTS)
    if unknown:
        parser.error(f"no such part: {', '.join(sorted(unknown))}; there are {', '.join(PARTS)}")
    different = 0
    for part in options.parts or PARTS:
        path, found = options.folder / f"{part}.json", ask(part)
        if options.verb == "record":
            options.folder.mkdir(parents=True, exist_ok=True)
            path.write_text(json.dumps(found, indent=0, sort_keys=True) + "\n", encoding="utf-8")
            print(f"{part}: {len(found)} answers")
            continue
        before = json.loads(path.read_text(encoding="utf-8"))
        keys = [k for k in sorted(before | found) if before.get(k) != found.get(k)]
        different += len(keys)
        print(f"{part}: {len(found)} answers, {len(keys)} differ")
        for key in keys[:5]:
            print(f"  {key}\n    was: {before.get(key)}\n    is:  {found.get(key)}")
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
