"""`so:` targets: C functions that are right, wrong, skip, crash, write too far, never return."""

from __future__ import annotations

import json
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from minkref.cli.cli import run
from minkref.fuzz.adapters.template import HEADER
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.verdicts.verdict import Outcome, Verdict
from thoroughness import draws

pytestmark = pytest.mark.skipif(not shutil.which("gcc"), reason="gcc is not installed")

SOURCE = """
#include "minkref_adapter.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Convex rings: all sums of two vertices, and their hull by gift wrapping. */
static int hull(const minkref_set* a, const minkref_set* b, minkref_set* sum, double shift) {
  if (a->rings != 1 || b->rings != 1) return MINKREF_SKIPPED;
  int m = a->sizes[0], n = b->sizes[0], count = 0, total = m * n;
  double* all = (double*)malloc(2 * sizeof(double) * (size_t)total);
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      all[2 * (i * n + j)] = a->xy[2 * i] + b->xy[2 * j] + shift;
      all[2 * (i * n + j) + 1] = a->xy[2 * i + 1] + b->xy[2 * j + 1];
    }
  sum->rings = 1;
  sum->sizes = (int*)malloc(sizeof(int));
  sum->xy = (double*)malloc(2 * sizeof(double) * (size_t)total);
  int start = 0, at, next;
  for (int i = 1; i < total; ++i)
    if (all[2 * i] < all[2 * start] ||
        (all[2 * i] == all[2 * start] && all[2 * i + 1] < all[2 * start + 1])) start = i;
  at = start;
  do {
    memcpy(sum->xy + 2 * count++, all + 2 * at, 2 * sizeof(double));
    next = -1;
    for (int i = 0; i < total; ++i) {
      double ux = all[2 * i] - all[2 * at], uy = all[2 * i + 1] - all[2 * at + 1];
      if (ux == 0 && uy == 0) continue;
      if (next < 0) { next = i; continue; }
      double vx = all[2 * next] - all[2 * at], vy = all[2 * next + 1] - all[2 * at + 1];
      double turn = vx * uy - vy * ux;
      if (turn < 0 || (turn == 0 && ux * ux + uy * uy > vx * vx + vy * vy)) next = i;
    }
    at = next;
  } while (count < total && memcmp(all + 2 * at, all + 2 * start, 2 * sizeof(double)));
  sum->sizes[0] = count;
  free(all);
  return MINKREF_RESULT;
}

#define SUM(name) int name(const minkref_set* a, const minkref_set* b, minkref_set* sum)
SUM(right) { return hull(a, b, sum, 0); }
SUM(wrong) { return hull(a, b, sum, 1); }
SUM(skips) { return MINKREF_SKIPPED; }
SUM(rejects) { return MINKREF_REJECTED; }
SUM(fails) { return MINKREF_ERRORED; }
SUM(odd_status) { return -77; }
SUM(crashes) { *(volatile int*)8 = 1; return hull(a, b, sum, 0); }
SUM(aborts) { abort(); }
SUM(leaves) { exit(0); }
SUM(never) { for (volatile int i = 0;; ++i) {} }
SUM(nothing_set) { return MINKREF_RESULT; }
SUM(no_arrays) { sum->rings = 3; return MINKREF_RESULT; }
SUM(negative) { sum->rings = -3; return MINKREF_RESULT; }
SUM(not_a_number) { int s = hull(a, b, sum, 0); sum->xy[0] = NAN; return s; }
SUM(infinite) { int s = hull(a, b, sum, 0); sum->xy[0] = INFINITY; return s; }
SUM(too_far) {
  int s = hull(a, b, sum, 0);
  memset(sum->xy, 65, (size_t)1 << 26);
  return s;
}
SUM(far_sizes) { int s = hull(a, b, sum, 0); sum->sizes[0] = 2000000000; return s; }
SUM(far_rings) { int s = hull(a, b, sum, 0); sum->rings = 2000000000; return s; }
SUM(not_by_malloc) {
  static int one[1] = {3};
  static double xy[6] = {0, 0, 1, 0, 0, 1};
  sum->rings = 1; sum->sizes = one; sum->xy = xy;
  return MINKREF_RESULT;
}
const char* minkref_hello(void) {
  return "{\\"name\\": \\"mine\\", \\"capabilities\\": [\\"plane\\"]}";
}
"""
EXPECTED = {
    "right": {Verdict.PASS, Verdict.PASS_WITHIN},
    "wrong": {Verdict.WRONG},
    "skips": {Verdict.ERRORED},
    "rejects": {Verdict.WRONG},
    "fails": {Verdict.ERRORED},
    "odd_status": {Verdict.ERRORED},
    "crashes": {Verdict.CRASHED},
    "aborts": {Verdict.CRASHED},
    "leaves": {Verdict.CRASHED},
    "never": {Verdict.TIMED_OUT},
    "nothing_set": {Verdict.WRONG},
    "no_arrays": {Verdict.ERRORED},
    "negative": {Verdict.ERRORED},
    "not_a_number": {Verdict.ERRORED},
    "infinite": {Verdict.ERRORED},
    "too_far": {Verdict.CRASHED},
    "far_sizes": {Verdict.ERRORED},
    "far_rings": {Verdict.CRASHED},
    "not_by_malloc": {Verdict.CRASHED},
}


def test_each_function_is_charged_with_what_it_does(
    tmp_path: Path,
    outcomes: Callable[..., list[Outcome]],
    follows_schema: Callable[[Any, str], None],
    capsys: pytest.CaptureFixture[str],
) -> None:
    """And a run over a few says the same."""
    source, library = tmp_path / "sums.c", tmp_path / "libsums.so"
    source.write_text(SOURCE, encoding="utf-8")
    words = ["gcc", "-std=c99", "-O1", "-shared", "-fPIC", f"-I{HEADER.parent}", str(source)]
    subprocess.run([*words, "-o", str(library), "-lm"], check=True, timeout=60)
    cases = [f"convex:1:{k}" for k in range(draws(1, 2))]
    for name, verdicts in EXPECTED.items():
        limits = Limits(seconds=0.3 if name == "never" else 60)
        said = outcomes(f"so:{library}:{name}", *cases, limits=limits)
        assert {outcome.verdict for outcome in said} <= verdicts, (name, said)
    names = {f"so:{library}:{name}": name for name in ("right", "wrong", "fails")}
    options = ["--case", "convex:1:0", "--shrink-calls", "0", "--jobs", "1", "--json"]
    assert run(["verify", *names, *options]) == 1
    value = json.loads(capsys.readouterr().out)
    follows_schema(value, "verify")
    for cell in value["matrix"]:
        assert set(cell["verdicts"]) <= EXPECTED[names[cell["target"]]]


GROWING = """
int grown(const minkref_set* P, double radius, minkref_set* out) {
  double xy[128];
  int size = 64;
  for (int k = 0; k < size; ++k) {
    xy[2 * k] = radius * cos(k * 3.14159265358979 / 32);
    xy[2 * k + 1] = radius * sin(k * 3.14159265358979 / 32);
  }
  minkref_set disc = {1, &size, NULL, xy};
  return hull(P, &disc, out, 0);
}
int shorter(const minkref_set* P, double radius, minkref_set* out) {
  return grown(P, radius / 2, out);
}
int last(const minkref_set* sets, int count, minkref_set* out) {
  double origin[2] = {0, 0};
  int size = 1;
  minkref_set point = {1, &size, NULL, origin};
  return hull(sets + count - 1, &point, out, 0);
}
const char* minkref_hello(void) {
  return "{\\"sum\\": \\"none\\", \\"capabilities\\": [\\"plane\\", \\"" VERB "\\"], "
         "\\"tolerance\\": {\\"relative\\": \\"1e-9\\", \\"radius\\": \\"0.0013\\"}}";
}
"""
JOINING = """
/* One level line, or the square, grown: no round joins. */
int grown(const minkref_set* P, double r, const minkref_manner* how, minkref_set* out) {
  double low = P->xy[0], high = P->xy[2], bottom = P->xy[1], top = P->xy[how->are_lines ? 1 : 5];
  double more = 0;
  if (how->are_lines) {
    if (P->rings != 1 || P->sizes[0] != 2) return MINKREF_SKIPPED;
    top = bottom;
    more = how->cap == MINKREF_SQUARE ? r : 0;
    if (how->cap == MINKREF_ROUND) return MINKREF_SKIPPED;
  } else {
    if (how->join != MINKREF_SHARP && !(how->join == MINKREF_MITRE && how->limit == 2))
      return MINKREF_SKIPPED;
    more = r;
  }
  double xy[] = {low - more, bottom - r, high + more, bottom - r,
                 high + more, top + r, low - more, top + r};
  out->rings = 1;
  out->sizes = (int*)malloc(sizeof(int));
  out->xy = (double*)malloc(sizeof(xy));
  out->sizes[0] = 4;
  memcpy(out->xy, xy, sizeof(xy));
  return MINKREF_RESULT;
}
const char* minkref_hello(void) {
  return "{\\"sum\\": \\"none\\", \\"capabilities\\": [\\"plane\\", \\"offset\\", "
         "\\"line-offset\\", \\"join-mitre\\", \\"join-sharp\\", \\"inset-sharp\\", "
         "\\"cap-flat\\", \\"cap-square\\"]}";
}
"""
SQUARE = {"polygons": [{"outer": [[0, 0], [2, 0], [2, 2], [0, 2]]}]}
INNER = {"polygons": [{"outer": [[0, 0], [1, 0], [1, 1], [0, 1]]}]}


def test_a_function_grows_or_unites(tmp_path: Path, outcomes: Callable[..., list[Outcome]]) -> None:
    source = tmp_path / "other.c"
    source.write_text(SOURCE.partition("const char*")[0] + GROWING, encoding="utf-8")
    words = ["gcc", "-std=c99", "-O1", "-shared", "-fPIC", f"-I{HEADER.parent}", str(source)]
    grow = json.dumps({"offset": SQUARE, "radius": "3/2"})
    asked = {
        ("offset", "grown", grow): Verdict.PASS_WITHIN,
        ("offset", "shorter", grow): Verdict.WRONG,
        ("union", "last", json.dumps({"sets": [INNER, SQUARE]})): Verdict.PASS,
        ("union", "last", json.dumps({"sets": [SQUARE, INNER]})): Verdict.WRONG,
    }
    for (verb, name, case), verdict in asked.items():
        library = tmp_path / f"lib{verb}.so"
        verbs = [f'-DVERB="{verb}"', "-o", str(library), "-lm"]
        subprocess.run([*words, *verbs], check=True, timeout=60)
        (said,) = outcomes(f"so:{library}:{name}", case)
        assert said.verdict is verdict, (name, said)


def test_a_function_grows_lines_and_joins(
    tmp_path: Path, outcomes: Callable[..., list[Outcome]]
) -> None:
    """Each manner as it is asked; a wrong one shows."""
    source, library = tmp_path / "joined.c", tmp_path / "libjoined.so"
    head = '#include "minkref_adapter.h"\n#include <stdlib.h>\n#include <string.h>\n'
    source.write_text(head + JOINING, encoding="utf-8")
    words = ["gcc", "-std=c99", "-O1", "-shared", "-fPIC", f"-I{HEADER.parent}", str(source)]
    subprocess.run([*words, "-o", str(library)], check=True, timeout=60)
    line = {"lines": [[[0, 0], [4, 0]]]}
    asked = [
        ({"offset": line, "radius": "1", "cap": "flat"}, Verdict.PASS_WITHIN),
        ({"offset": line, "radius": "1", "cap": "square"}, Verdict.PASS_WITHIN),
        ({"offset": line, "radius": "1"}, Verdict.ERRORED),  # declared, and skipped
        ({"offset": SQUARE, "radius": "1", "join": "sharp"}, Verdict.PASS_WITHIN),
        ({"offset": SQUARE, "radius": "-1/2", "join": "sharp"}, Verdict.PASS_WITHIN),
        ({"offset": SQUARE, "radius": "1", "join": "mitre", "limit": "2"}, Verdict.PASS_WITHIN),
        ({"offset": SQUARE, "radius": "1", "join": "mitre", "limit": "3"}, Verdict.ERRORED),
        ({"offset": SQUARE, "radius": "1", "join": "bevel"}, Verdict.SKIPPED),
    ]
    said = outcomes(f"so:{library}:grown", *(json.dumps(case) for case, _ in asked))
    assert [one.verdict for one in said] == [verdict for _, verdict in asked], said
