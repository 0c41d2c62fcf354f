"""Changed files of minkref: indices, certificates and ledgers. The commands that write them make
each original once."""

from __future__ import annotations

import functools
import gzip
import json
import os
import struct
import subprocess
import sys
import tempfile
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

from hostile_file import FILE, JUDGED, STATE, Hostile, sparse

INDEX = ("sum", "g1", "g2", "--index", FILE)
VIEW = ("view", "g1", "g2", "--index", FILE, "-o", "out.html")
EVENTS = ("events", "g1", "g2", "--kind", "boundary", "--index", FILE)
CHECK = ("check", FILE)
RUN = ("verify", "minkref:winding", "--pairs", "2", "--no-models", "--jobs", "1")
LEDGER = (*RUN, "--ledger", FILE)
BAD_CERTIFICATE = (1, 2, 4)
COLUMNS = 29


@functools.cache
def made(name: str) -> dict[str, bytes]:
    """The files that a command writes into an empty folder."""
    commands = {
        "index": ("index", "g1", "g2", "--from", "1/4", "--to", "4", "-o", "it"),
        "plane": ("certify", "g1", "g2", "-o", "sum.cert.json"),
        "space": ("certify", "gs3", "gs4", "-o", "sum.cert.json"),
        "ledger": (*RUN, "--ledger", "it"),
    }
    with tempfile.TemporaryDirectory() as folder:
        words = [sys.executable, "-m", "minkref", *commands[name]]
        environment = {**os.environ, **STATE}
        subprocess.run(words, cwd=folder, env=environment, check=True, capture_output=True)
        return {path.name: path.read_bytes() for path in Path(folder).iterdir()}


def index(change: Callable[[bytearray], None], *, mended: bool = True) -> Callable[[Path], None]:
    """Writes the index, changed; `mended` corrects its checksum, as a forger would."""

    def make(path: Path) -> None:
        data = bytearray(made("index")["it"])
        change(data)
        if mended and len(data) >= 32:
            data[24:28] = bytes(4)
            data[24:28] = struct.pack("<I", zlib.crc32(data))
        path.write_bytes(data)

    return make


def directory(column: int, field: str, value: int) -> Callable[[bytearray], None]:
    at, form = {"begin": (0, "<Q"), "count": (8, "<Q"), "bytes": (16, "<I"), "words": (20, "<I")}[
        field
    ]

    def change(data: bytearray) -> None:
        struct.pack_into(form, data, 32 + 24 * column + at, value)

    return change


def header(at: int, form: str, value: int) -> Callable[[bytearray], None]:
    return lambda data: struct.pack_into(form, data, at, value)


def elements(column: int, value: int) -> Callable[[bytearray], None]:
    """Replaces all numbers of a column with one value."""

    def change(data: bytearray) -> None:
        begin, count = struct.unpack_from("<QQ", data, 32 + 24 * column)
        (size,) = struct.unpack_from("<I", data, 32 + 24 * column + 16)
        for at in range(begin, begin + count * size, 4):
            struct.pack_into("<I", data, at, value)

    return change


def cut(length: int) -> Callable[[bytearray], None]:
    def change(data: bytearray) -> None:
        del data[length:]

    return change


def indices() -> list[Hostile]:
    wrong = {
        "cut to nothing": cut(0),
        "cut in its header": cut(31),
        "cut in its directory": cut(400),
        "another letter at first": header(0, "<I", 0),
        "version 2": header(8, "<I", 2),
        "another order of bytes": header(12, "<I", 0x04030201),
        "a length of 2^64 - 1": header(16, "<Q", 2**64 - 1),
        "no columns": header(28, "<I", 0),
        "four billion columns": header(28, "<I", 2**32 - 1),
        "a column that begins behind the end": directory(14, "begin", 2**63),
        "a column that begins in the header": directory(14, "begin", 8),
        "a column that begins so that its end is before it": directory(14, "begin", 2**64 - 8),
        "a column of 2^64 - 1 elements": directory(12, "count", 2**64 - 1),
        "a column of 2^61 elements": directory(12, "count", 2**61),
        "elements of no bytes": directory(15, "bytes", 0),
        "integers of four billion words": directory(10, "words", 2**32 - 1),
        "integers of no words": directory(10, "words", 0),
    }
    found = [
        Hostile(f"index, {title}", "made.index", index(change), command)
        for k, (title, change) in enumerate(wrong.items())
        for command in ((INDEX, VIEW, EVENTS)[k % 3],)
    ]
    found += [
        Hostile(
            f"index, column {column} all {value:#x}",
            "made.index",
            index(elements(column, value)),
            (INDEX, VIEW, EVENTS)[column % 3],
            JUDGED,
        )
        for column in range(COLUMNS)
        for value in (0xFFFFFFFF,)
    ]
    shifted = index(lambda data: data.__setitem__(5000, data[5000] ^ 1), mended=False)
    return [
        *found,
        Hostile("index, a bit turned", "made.index", shifted, INDEX),
        Hostile("index, sixteen gigabytes of zeros", "made.index", sparse(1 << 34), INDEX),
        Hostile(
            "index, gigabytes behind its first letters",
            "made.index",
            sparse(1 << 31, b"minkrefI" + struct.pack("<IIQII", 1, 0x01020304, 1 << 31, 0, 29)),
            INDEX,
        ),
    ]


Json = dict[str, Any]


def certificate(
    kind: str,
    change: Callable[[Json], object] | None = None,
    text: Callable[[bytes], bytes] = bytes,
) -> Callable[[Path], None]:
    """Writes the certificate beside its case; changes first the value, then the text."""

    def make(path: Path) -> None:
        files = made(kind)
        (path.parent / "sum.case.json").write_bytes(files["sum.case.json"])
        data = files["sum.cert.json"]
        if change:
            value = json.loads(data)
            change(value)
            data = json.dumps(value).encode()
        path.write_bytes(text(data))

    return make


def put(*where: str | int, value: object) -> Callable[[Json], object]:
    """Sets a member, down a path of names and numbers."""

    def change(document: Json) -> None:
        inner: Any = document
        for step in where[:-1]:
            inner = inner[step]
        inner[where[-1]] = value

    return change


def in_case(text: str) -> Callable[[Path], None]:
    """A right certificate whose case has another text."""

    def make(path: Path) -> None:
        certificate("plane")(path)
        (path.parent / "sum.case.json").write_text(text, encoding="utf-8")

    return make


def bomb(size: int) -> Callable[[bytes], bytes]:
    return lambda data: gzip.compress(data[:-1] + b" " * size + b"}")


PLANE_CHANGES: dict[str, Callable[[Json], object]] = {
    "a case that is a device": put("case", "path", value="/dev/zero"),
    "a case that waits for ever": put("case", "path", value="/dev/tty"),
    "a case that is the certificate": put("case", "path", value="sum.cert.json"),
    "a case with a NUL in its name": put("case", "path", value="a\0b"),
    "a case that is a folder": put("case", "path", value=".."),
    "a case with a name of a megabyte": put("case", "path", value="x" * 10**6),
    "a piece of a vertex of 2^64": put("steps", 0, "pieces", 0, value=[2**64, 0, 1]),
    "a piece of a vertex below zero": put("steps", 0, "pieces", 0, value=[-1, 0, 1]),
    "a group that contains itself": put("steps", 0, "groups", 0, value=[12, 12]),
    "a hundred thousand groups": put("steps", 0, "groups", value=[[0]] * 100_000),
    "a scale of a million digits": put("claims", 0, "scale", value="7" * 10**6),
    "a scale of 99,999 digits": put("claims", 0, "scale", value="7" * 99_999),
    "a scale with an exponent of a billion": put("claims", 0, "scale", value="1e1000000000"),
    "a scale with underscores": put("claims", 0, "scale", value="1_0/1_0"),
    "a scale in Arabic digits": put("claims", 0, "scale", value="\u0661"),
    "a scale by zero": put("claims", 0, "scale", value="1/00"),
    "an unknown rule": put("steps", 0, "rule", value="believe"),
    "a rule that is a list": put("steps", 0, "rule", value=[]),
    "claims that are an object": put("claims", value={}),
    "no claims": put("claims", value=[]),
    "a hundred thousand claims": lambda value: put("claims", value=value["claims"] * 100_000)(
        value
    ),
    "true in place of an index": put("steps", 0, "pieces", 0, 0, value=True),
    "another number of holes": put("claims", 0, "holes", value=10**30),
}
TEXT_CHANGES: dict[str, Callable[[bytes], bytes]] = {
    "a member twice": lambda data: data[:-2] + b', "claims": []}',
    "not a number": lambda data: data.replace(b'"components":1', b'"components":NaN'),
    "a mark of byte order": lambda data: b"\xef\xbb\xbf" + data,
    "UTF-16": lambda data: data.decode().encode("utf-16"),
    "half a surrogate": lambda data: data.replace(b'"title":"g', b'"title":"\\ud800', 1),
    "a NUL behind it": lambda data: data + b"\0",
    "half of it": lambda data: data[: len(data) // 2],
    "lists a million deep": lambda data: b"[" * 10**6,
    "objects a million deep": lambda data: b'{"a":' * 10**6,
}


def certificates() -> list[Hostile]:
    name = "sum.cert.json"
    found = [
        Hostile(f"certificate, {title}", name, certificate("plane", change), CHECK, BAD_CERTIFICATE)
        for title, change in PLANE_CHANGES.items()
    ]
    found += [
        Hostile(f"certificate, {title}", name, certificate("plane", text=change), CHECK, (1, 2, 4))
        for title, change in TEXT_CHANGES.items()
    ]
    zipped = "sum.cert.json.gz"
    twice = certificate("plane", text=lambda data: gzip.compress(data) * 2)
    tail = certificate("plane", text=lambda data: gzip.compress(data) + b"x")
    short = certificate("plane", text=lambda data: gzip.compress(data)[:-9])
    space = {
        "a face of a vertex that is not there": put("sums", 0, "facets", 0, 0, 0, value=10**9),
        "a scaling of four": put("sums", 0, "scaling", value=["1"] * 4),
        "no facets": put("sums", 0, "facets", value=[]),
        "a volume with an exponent of a billion": put("claims", 0, "volume", value="1e1000000000"),
    }
    found += [
        Hostile(f"certificate in space, {t}", name, certificate("space", c), CHECK, (1, 2, 4))
        for t, c in space.items()
    ]
    return [
        *found,
        Hostile("certificate, zipped: 4 GB of spaces", zipped,
                lambda path: certificate("plane", text=bomb(1 << 32))(path), CHECK, (2, 4),
                seconds=60),
        Hostile("certificate, zipped twice", zipped, twice, CHECK, (2,)),
        Hostile("certificate, zipped with a tail", zipped, tail, CHECK, (2,)),
        Hostile("certificate, zipped and cut", zipped, short, CHECK, (2,)),
        Hostile("certificate of gigabytes", name, sparse(1 << 33, b"{"), CHECK, (2, 4)),
        Hostile("certificate with a case of lists", name, in_case("[" * 10**6), CHECK, (1, 2)),
        Hostile("certificate with a case of an exponent", name,
                in_case('{"P":{"polygons":[{"outer":[["1e1_000_000_000","0"]]}]},"Q":{}}'), CHECK,
                (1, 2)),
    ]  # fmt: skip


def ledger(change: Callable[[list[str]], list[str]]) -> Callable[[Path], None]:
    def make(path: Path) -> None:
        lines = made("ledger")["it"].decode().splitlines()
        path.write_text("".join(line + "\n" for line in change(lines)), encoding="utf-8")

    return make


def forged(lines: list[str]) -> list[str]:
    return [line.replace('"pass"', '"wrong"') for line in lines]


def ledgers() -> list[Hostile]:
    wrong: dict[str, Callable[[list[str]], list[str]]] = {
        "another verdict": forged,
        "a line out of the middle": lambda lines: [lines[0], *lines[2:]],
        "a line twice": lambda lines: [*lines, lines[-1]],
        "two lines in another order": lambda lines: [lines[0], *reversed(lines[1:])],
        "another first line": lambda lines: [lines[0].replace('"seed":1', '"seed":2'), *lines[1:]],
        "no first line": lambda lines: lines[1:],
        "a first line of lists": lambda lines: ["[" * 10**6, *lines[1:]],
        "a first line of 50 MB": lambda lines: [
            lines[0].replace("ledger-v3", "x" * (50 << 20)), *lines[1:]],
        "another number": lambda lines: [lines[0], lines[1].replace('"number":0', '"number":1e99')],
        "lines of an object without members": lambda lines: [lines[0], "{}", "{}"],
        "lines of null": lambda lines: [lines[0], "null", *lines[1:]],
        "an empty line": lambda lines: [lines[0], "", *lines[1:]],
        "a member twice": lambda lines: [
            lines[0], lines[1].replace('"outcomes"', '"outcomes":[],"outcomes"')],
        "a NUL": lambda lines: [lines[0], lines[1].replace('"pass"', '"pa\0ss"')],
    }  # fmt: skip
    return [
        *(
            Hostile(f"ledger, {title}", "run.ledger", ledger(change), LEDGER)
            for title, change in wrong.items()
        ),
        Hostile("ledger, not UTF-8", "run.ledger", b'{"ledger": "\xff"}\n', LEDGER),
        Hostile("ledger, gigabytes of zeros", "run.ledger", sparse(1 << 33), LEDGER),
        Hostile("ledger, an end within a line", "run.ledger", half_a_line, LEDGER, (0,)),
    ]


def half_a_line(path: Path) -> None:
    """Cuts the ledger as a killed run leaves it: this is no damage."""
    ledger(list)(path)
    data = path.read_bytes()
    path.write_bytes(data[:-20])
