"""The C header for sums compiles alone, as C and as C++."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest
from minkref.fuzz.adapters.template import HEADER

SOURCE = """
#include "minkref_adapter.h"
#include <stdlib.h>

#ifdef __cplusplus
extern "C"
#endif
int my_sum(const minkref_set* sP, const minkref_set* Q, minkref_set* sum);

int my_sum(const minkref_set* sP, const minkref_set* Q, minkref_set* sum) {
  if (sP->rings != 1 || Q->rings != 1 || Q->sizes[0] != 1) return MINKREF_SKIPPED;
  sum->rings = 1;
  sum->sizes = (int*)malloc(sizeof(int));
  sum->sizes[0] = sP->sizes[0];
  sum->xy = (double*)malloc(2 * sizeof(double) * (size_t)sP->sizes[0]);
  for (int i = 0; i < 2 * sP->sizes[0]; ++i) sum->xy[i] = sP->xy[i] + Q->xy[i % 2];
  return MINKREF_RESULT;
}

static int grown(const minkref_set* P, double radius, const minkref_manner* manner,
                 minkref_set* out) {
  return manner->are_lines || manner->join != MINKREF_ROUND || manner->cap != MINKREF_ROUND ||
                 radius > manner->limit
             ? MINKREF_SKIPPED
             : my_sum(P, P, out);
}

minkref_sum_function* const check = my_sum;
minkref_joined_offset_function* const checked = grown;
const char* minkref_hello(void) { return "{\\"name\\": \\"mine\\"}"; }
"""


@pytest.mark.parametrize("words", [["gcc", "-std=c99"], ["g++", "-std=c++17"]])
def test_the_header_compiles_alone(words: list[str], tmp_path: Path) -> None:
    if not shutil.which(words[0]):
        pytest.skip(f"{words[0]} is not installed")
    ending = "c" if words[0] == "gcc" else "cpp"
    source = tmp_path / f"mine.{ending}"
    source.write_text(SOURCE, encoding="utf-8")
    strict = ["-Wall", "-Wextra", "-Wpedantic", "-Werror", "-shared", "-fPIC"]
    library = str(tmp_path / "libmine.so")
    include = f"-I{HEADER.parent}"
    subprocess.run([*words, *strict, include, str(source), "-o", library], check=True, timeout=60)
