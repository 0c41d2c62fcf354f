"""`minkref adapter check`: what an adapter declares, and four sums; declarations of functions."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from forked import forked
from minkref.schemas import schema
from thoroughness import THOROUGH

HULL = '''
def hull(P, Q):
    """The hull of the sums of all vertices, whatever the operands are."""
    points = sorted(
        {
            (a + c, b + d)
            for p in P["polygons"]
            for a, b in p["outer"]
            for q in Q["polygons"]
            for c, d in q["outer"]
        }
    )
    sides = []
    for run in (points, points[::-1]):
        side = []
        for x, y in run:
            while len(side) > 1 and (side[-1][0] - side[-2][0]) * (y - side[-2][1]) <= (
                side[-1][1] - side[-2][1]
            ) * (x - side[-2][0]):
                side.pop()
            side.append((x, y))
        sides += side[:-1]
    return {"polygons": [{"outer": sides, "holes": []}]}


hull.minkref = {
    "name": "hull",
    "version": "3.1",
    "arithmetic": "float64",
    "numbers": "double",
    "tolerance": {"absolute": "0", "relative": "1e-9"},
    "capabilities": ["plane", WORDS],
}
'''


def run(folder: Path, *words: str) -> tuple[int, Any]:
    ran = forked(folder, *words, "--json")
    assert "Traceback" not in ran.stderr, ran.stderr
    return ran.returncode, json.loads(ran.stdout)


def check(folder: Path, name: str) -> tuple[int, Any]:
    code, value = run(folder, "adapter", "check", name)
    jsonschema.validate(value, schema("adapter_check"))
    return code, value


def module(folder: Path, words: str, name: str = "hulls") -> str:
    (folder / f"{name}.py").write_text(HULL.replace("WORDS", words))
    return f"py:{name}:hull"


def test_a_function_of_the_current_folder_says_what_it_takes(tmp_path: Path) -> None:
    code, value = check(tmp_path, module(tmp_path, '"rejects-invalid"'))
    assert code == 0
    target = value["target"]
    assert (target["version"], target["arithmetic"], target["numbers"]) == (
        "3.1",
        "float64",
        "double",
    )
    assert "holes" in value["left_out"] and "plane" not in value["left_out"]
    assert [row["verdict"] for row in value["sums"][:2]] == ["pass"] * 2
    assert [row["verdict"] for row in value["sums"][2:]] == ["skipped"] * 2


def test_a_hull_in_place_of_a_sum_is_wrong_at_once(tmp_path: Path) -> None:
    code, value = check(tmp_path, module(tmp_path, '"non-convex", "holes"'))
    assert code == 1
    assert [row["verdict"] for row in value["sums"]] == [*["pass"] * 2, *["wrong"] * 2]
    assert all(row["witness"] for row in value["sums"][2:])


NO_DECLARATIONS = (
    ('"tolerance"', '"tolerence"', "no member 'tolerence'; did you mean tolerance?"),
    ('"relative"', '"relativ"', "no member of tolerance 'relativ'; did you mean relative?"),
    ('"plane"', '"plan"', "no capability 'plan'; did you mean plane?"),
    ('"version": "3.1"', '"version": 3.1', "version is not a text"),
    ('"numbers": "double"', '"grid": {"bit": 4}', "no member of grid 'bit'; did you mean bits?"),
)


@pytest.mark.parametrize(("old", "new", "said"), NO_DECLARATIONS)
def test_a_declaration_that_is_none_is_refused(
    tmp_path: Path, old: str, new: str, said: str
) -> None:
    """Takes the two commands in turn."""
    name = module(tmp_path, '"holes"')
    text = (tmp_path / "hulls.py").read_text()
    assert old in text
    (tmp_path / "hulls.py").write_text(text.replace(old, new))
    commands = [("adapter", "check"), ("verify",)]
    turn = NO_DECLARATIONS.index((old, new, said)) % 2
    for command in commands if THOROUGH else [commands[turn]]:
        code, value = run(tmp_path, *command, name)
        assert code == 2 and said in value["error"]["what"]


def test_members_that_begin_with_x_are_ignored(tmp_path: Path) -> None:
    name = module(tmp_path, '"holes"')
    text = (tmp_path / "hulls.py").read_text()
    (tmp_path / "hulls.py").write_text(text.replace('"name": "hull"', '"x-home": "here"'))
    assert check(tmp_path, name)[0] == 0


def test_invalid_input_is_put_to_a_function_that_declares_so_and_a_baseline_knows_its_version(
    tmp_path: Path,
) -> None:
    name = module(tmp_path, '"rejects-invalid"')
    more = ("--pairs", "12", "--jobs", "1", "--no-models", "--shrink-calls", "0")
    code, value = run(tmp_path, "verify", name, *more)
    assert code == 1
    assert {f["target_version"] for f in value["findings"]} == {"3.1"}
    assert {tuple(f["reasons"]) for f in value["findings"]} == {("accepted-invalid",)}
    assert value["targets"][0]["arithmetic"] == "float64"
    entry = {"target": name, "kind": "accepted-invalid", "reason": "it never looks"}
    baseline = tmp_path / "known.json"
    for version, expected in (("3.1", 0), ("3.0", 1)):
        known = {"baseline": "baseline-v1", "entries": [{**entry, "version": version}]}
        baseline.write_text(json.dumps(known))
        code, _ = run(tmp_path, "verify", name, *more, "--baseline", str(baseline))
        assert code == expected, version


def test_the_name_of_a_program_beside_is_not_looked_for_elsewhere(tmp_path: Path) -> None:
    """`./true` differs from /bin/true."""
    (tmp_path / "true").write_text("#!/bin/sh\nexit 5\n")
    (tmp_path / "true").chmod(0o755)
    code, value = run(tmp_path, "adapter", "check", "./true")
    assert code == 2 and "exit code 5" in value["error"]["what"]


def library(path: Path, hello: str) -> None:
    """A C library with this text as its hello, and a sum that fails."""
    source = path.with_suffix(".c")
    source.write_text(
        f'const char *minkref_hello(void) {{ return "{hello}"; }}\n'
        "int sum(void *p, void *q, void *r) { (void)p; (void)q; (void)r; return 1; }\n"
    )
    subprocess.run(["cc", "-shared", "-fPIC", str(source), "-o", str(path)], check=True)


def test_a_library_beside_is_found_with_and_without_its_folder(tmp_path: Path) -> None:
    library(tmp_path / "libempty.so", '{\\"version\\": \\"7\\"}')
    for path in ("./libempty.so", "libempty.so"):
        code, value = check(tmp_path, f"so:{path}:sum")
        assert (code, value["target"]["version"]) == (3, "7")
        assert {row["verdict"] for row in value["sums"]} == {"errored"}


CUBES = """
def ends(solid):
    return [[end(v[k] for v in solid["vertices"]) for k in range(3)] for end in (min, max)]


def box(P, Q):
    a, b, c, d = *ends(P), *ends(Q)
    low, high = ([m + n for m, n in zip(*pair)] for pair in ((a, c), (b, d)))
    corners = [[x, y, z] for x in (low[0], high[0]) for y in (low[1], high[1])
               for z in (low[2], high[2])]
    faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    return {"vertices": corners, "faces": faces}

box.minkref = {"capabilities": ["space", "non-convex"], "numbers": "double"}
"""


def test_a_function_that_declares_space_is_asked_in_space(tmp_path: Path) -> None:
    (tmp_path / "cubes.py").write_text(CUBES)
    code, value = check(tmp_path, "py:cubes:box")
    assert code == 1
    assert [row["verdict"] for row in value["sums"]] == ["pass", "pass", "wrong", "skipped"]


def test_a_library_that_declares_space_is_refused(tmp_path: Path) -> None:
    library(tmp_path / "libspace.so", '{\\"capabilities\\": [\\"space\\"]}')
    code, value = run(tmp_path, "adapter", "check", "so:./libspace.so:sum")
    assert code == 2 and "a C function is for the plane" in value["error"]["what"]
