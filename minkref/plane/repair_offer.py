"""The hint of a refusal that `minkref repair` mends the file."""

from __future__ import annotations

import shlex
from collections.abc import Callable, Collection, Iterator
from contextlib import contextmanager
from pathlib import Path

from minkref.errors import Refusal
from minkref.output.terminal import escaped

#: Refusals of sets in the plane that a repair mends, whatever else the file holds.
MENDED = (
    "ring-not-closed", "too-few-vertices", "zero-length-edge", "zero-area", "self-intersection",
    "wrong-orientation", "overlapping-rings", "crossing-rings", "hole-outside", "mixed-operand",
    "overlapping-polygons",
)  # fmt: skip


@contextmanager
def offering_repair(
    file: Path, codes: Collection[str], is_mended: Callable[[], bool] = lambda: True
) -> Iterator[None]:
    """Add the mending command to refusals with one of `codes`, if a file exists and `is_mended`
    agrees."""
    try:
        yield
    except Refusal as refusal:
        if refusal.code not in codes or not file.is_file() or not is_mended():
            raise
        line = f"`minkref repair {shlex.quote(escaped(str(file)))} -o FILE.json` mends the file"
        mend = f"{refusal.mend}; {line}"
        raise Refusal(refusal.what, refusal.where, mend, refusal.code) from refusal
