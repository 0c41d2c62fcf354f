"""Hostile settings, baselines, lists of scales, cases, and folders that a command looks into."""

from __future__ import annotations

from pathlib import Path

from hostile_file import FILE, JUDGED, Hostile, Large, case, sparse

SETTINGS = ("verify", "minkref:winding", "--settings", FILE, "--pairs", "1", "--no-models")
BASELINE = ("verify", "minkref:winding", "--pairs", "1", "--no-models", "--baseline", FILE)
SCALES = ("sweep", "g1", "g2", "--scales", FILE, "-o", "out")
CASE = ("verify", "minkref:winding", "--case", FILE)
OF_CASE = ("sum", f"{FILE}#P", f"{FILE}#Q", "-o", "out.json")
CORPUS = ("verify", "minkref:winding", "--suite", "corpus", "--corpus", "corpus")
MODELS = ("models",)
MILLION = 10**6
TRIANGLE = '[["0","0"],["1","0"],["0","1"]]'

TOML: dict[str, str | bytes] = {
    "no TOML": "targets = [",
    "not UTF-8": b'targets = ["\xff"]',
    "a NUL": 'targets = ["minkref:winding\0"]',
    "UTF-16": 'targets = ["minkref:winding"]'.encode("utf-16"),
    "a key twice": "seed = 1\nseed = 2\n",
    "an unknown key": "seconds-of-fun = 1\n",
    "a key that obeys a terminal": '"\\u001b[2J\\u0007" = 1\n',
    "a key of a megabyte": f"{'x' * MILLION} = 1\n",
    "lists in lists": "targets = " + "[" * 100_000 + "]" * 100_000,
    "tables in tables": "[" + ".".join(["a"] * 20_000) + "]\n",
    "an integer of a million digits": f"seed = {'7' * MILLION}\n",
    "an integer beyond every type": f"seed = {10**30}\n",
    "not a number": "seconds = nan\n",
    "infinity": "seconds = inf\n",
    "seconds below zero": "seconds = -1\n",
    "jobs below zero": "jobs = -1\n",
    "jobs by the million": "jobs = 1000000\n",
    "no memory": "call-memory = 0\n",
    "memory below zero": "call-memory = -1\n",
    "a text for a number": 'pairs = "ten"\n',
    "a date for a number": "pairs = 1979-05-27\n",
    "a table for a text": "targets = {a = 1}\n",
    "a setting that reads settings": 'settings = "other.toml"\n',
    "a target with a NUL": 'targets = ["./a\\u0000b"]\n',
    "a command without an end": 'targets = ["cmd:python \'"]\n',
    "an empty target": 'targets = [""]\n',
    "a module that is a path": 'targets = ["py:../../etc:passwd"]\n',
}
TAKEN = {  # a seed has any length; targets of the command line win over these
    title: JUDGED
    for title in (
        *("an integer of a million digits", "an integer beyond every type", "infinity"),
        *("jobs by the million", "a target with a NUL", "a command without an end"),
        *("an empty target", "a module that is a path", "not a number"),
    )
}
BASELINES: dict[str, str | bytes] = {
    "no JSON": "{",
    "not UTF-8": b'{"baseline": "\xff"}',
    "lists": "[" * MILLION,
    "another version": '{"baseline": "baseline-v9", "entries": []}',
    "entries that are an object": '{"baseline": "baseline-v1", "entries": {}}',
    "an entry that is a text": '{"baseline": "baseline-v1", "entries": ["all"]}',
    "an entry without a reason": (
        '{"baseline": "baseline-v1", "entries": '
        '[{"target": "*", "version": "*", "kind": "wrong"}]}'),
    "an unknown member": '{"baseline": "baseline-v1", "entries": [], "more": 1}',
    "a member twice": '{"baseline": "baseline-v1", "entries": [], "entries": []}',
    "not a number": '{"baseline": "baseline-v1", "entries": NaN}',
    "half a surrogate": '{"baseline": "\\ud800", "entries": []}',
}  # fmt: skip
STARS = (
    '{"baseline": "baseline-v1", "entries": [{"target": "' + "*a" * 5000 + 'b", "version": "*", '
    '"kind": "missing", "reason": "none"}]}'
)
SCALE_LISTS: dict[str, str | bytes | Large] = {
    "an exponent with underscores": "1e1_000_000_000\n",
    "an exponent of a billion": "1e1000000000\n",
    "an exponent below minus a billion": "1e-1000000000\n",
    "Arabic digits": "\u0661\n",
    "zero": "0\n",
    "by zero": "1/0\n",
    "a million digits": "7" * MILLION + "\n",
    "a line of 50 MB": Large(lambda: "#" + "x" * (50 << 20) + "\n"),
    "comments alone": "# 1\n" * 1000,
    "not UTF-8": b"1\n\xff\n",
    "a NUL": b"1\n2\0\n",
    "two million lines": "1\n" * (2 * MILLION),
    "three factors in the plane": "1,2,3\n",
}
HOLE = '[["0","0"],["9","0"],["9","9"],["0","9"]]'
CASES: dict[str, tuple[str, tuple[str, ...]]] = {
    "lists": ("[" * MILLION, CASE),
    "no operand": ('{"schema":"case-v1","id":"x","dimension":2,"scales":["1"]}', CASE),
    "a dimension of 2^64": (case(TRIANGLE).replace('"dimension":2', f'"dimension":{2**64}'), CASE),
    "a dimension that is a text": (case(TRIANGLE).replace('"dimension":2', '"dimension":"2"'),
                                   CASE),
    "a scale of zero": (case(TRIANGLE).replace('"scales":["1"]', '"scales":["0"]'), CASE),
    "a scale with an exponent of a billion": (
        case(TRIANGLE).replace('"scales":["1"]', '"scales":["1e1_000_000_000"]'), CASE),
    "a scale of a million digits": (
        case(TRIANGLE).replace('"scales":["1"]', f'"scales":["{"7" * MILLION}"]'), CASE),
    "no scales": (case(TRIANGLE).replace('"scales":["1"]', '"scales":[]'), CASE),
    "an interval whose end is before its begin": (
        case(TRIANGLE).replace('"scales":["1"]', '"interval":{"from":"2","to":"1"}'), CASE),
    "both scales and an interval": (
        case(TRIANGLE, more=',"interval":{"from":"1","to":"2"}'), CASE),
    "an id that is a path": (case(TRIANGLE).replace('"id":"hostile"', '"id":"../../etc/x"'), CASE),
    "a member twice": (case(TRIANGLE, more=',"P":{"polygons":[]}'), CASE),
    "a coordinate with underscores": (case('[["1_0","0"],["1","0"],["0","1"]]'), CASE),
    "a ring that runs the wrong way": (case('[["0","0"],["0","1"],["1","0"]]'), OF_CASE),
    "expected results of a million": (
        case(TRIANGLE, more=',"expected":[' + ",".join(['{"scale":"1"}'] * 300_000) + "]"),
        OF_CASE),
    "another schema": (case(TRIANGLE).replace("case-v1", "case-v9"), OF_CASE),
}  # fmt: skip
ALLOWED = {"a name of HTML": JUDGED, "an id that is a path": JUDGED,
           "expected results of a million": JUDGED}  # fmt: skip


def in_folder(name: str, data: bytes) -> object:
    def make(path: Path) -> None:
        path.mkdir()
        (path / name).write_bytes(data)

    return make


def corpus(data: str, name: str = "a.json") -> Hostile:
    title = f"corpus, {name}, {data[:30]!r}"
    return Hostile(title, "corpus", in_folder(name, data.encode()), CORPUS)  # type: ignore[arg-type]


FILES = [
    *(
        Hostile(f"settings, {t}", "minkref.toml", text, SETTINGS, TAKEN.get(t, (2,)))
        for t, text in TOML.items()
    ),
    Hostile("settings, a table that is a text", "pyproject.toml", 'tool.minkref = "all"', SETTINGS),
    Hostile("settings, a tool that is a number", "pyproject.toml", "tool = 1", SETTINGS),
    Hostile("settings, gigabytes", "minkref.toml", sparse(1 << 33), SETTINGS),
    *(Hostile(f"baseline, {t}", "known.json", text, BASELINE) for t, text in BASELINES.items()),
    Hostile("baseline, stars by the thousand", "known.json", STARS, BASELINE, JUDGED),
    Hostile("baseline, gigabytes", "known.json", sparse(1 << 33, b"{"), BASELINE),
    *(Hostile(f"scales, {t}", "scales.txt", text, SCALES) for t, text in SCALE_LISTS.items()),
    Hostile("scales, gigabytes", "scales.txt", sparse(1 << 33, b"1\n"), SCALES),
    *(
        Hostile(f"case, {title}", "case.json", text, command, ALLOWED.get(title, (2,)))
        for title, (text, command) in CASES.items()
    ),
    Hostile("case, gigabytes", "case.json", sparse(1 << 33, b"{"), CASE),
    corpus("[" * MILLION),
    corpus('{"schema": "case-v1"}'),
    Hostile("corpus, a case of gigabytes", "corpus", lambda path: large_in(path), CORPUS),
    Hostile(
        "models, a folder of hostile names",
        "models",
        in_folder("\x1b[2J\u202e.poly", b"1\n3 out\n0 0\n1 0\n0 1\n"),  # type: ignore[arg-type]
        MODELS,
        JUDGED,
        environment={"MINKREF_MODELS": FILE},
    ),
    Hostile(
        "models, a bird of gigabytes",
        "models",
        lambda path: large_in(path, "bird.poly"),
        ("sum", "bird", "g3", "-o", "out.json"),
        environment={"MINKREF_MODELS": FILE},
    ),
]


def large_in(path: Path, name: str = "a.json") -> None:
    path.mkdir()
    sparse(1 << 33, b"{")(path / name)
