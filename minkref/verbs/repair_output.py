"""Output of `minkref repair`: the changes, and the operand."""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.cli.memory import SIMPLER, memory_wall
from minkref.cli.output import give, measure, print_lines, written_row
from minkref.drawings.drawing import is_drawing
from minkref.errors import Refusal, choice, refusing
from minkref.file_text import bytes_of_file
from minkref.output.documents import Stopwatch, document, refuse_overwriting, write_together
from minkref.output.output_target import Target, target_of
from minkref.output.terminal import escaped
from minkref.repair.change import Change, told
from minkref.repair.rules import RULES
from minkref.space.operand import is_polyhedron
from minkref.verbs.repair import RepairRequest

PLANE = "minkref.plane.commands.repair"
SPACE = "minkref.space.commands.repair"
MOST_TOLD = 40  # changes in the text


@dataclass(frozen=True)
class Repaired:
    """A repaired operand. `file`: the source, if any; `write`, `is_exact`: text in a format, and
    whether the text holds the very set."""

    file: Path | None
    dimension: int
    changes: list[Change]
    warnings: list[str]
    measures: dict[str, Any]
    write: Callable[[str], str]
    is_exact: Callable[[str], bool]
    check: Callable[[str, str], object]


def run(request: RepairRequest) -> None:
    """Repair, with the setting's own function."""
    module = SPACE if is_polyhedron(request.file) else PLANE
    import_module(module).run(request)


def answer(
    request: RepairRequest,
    forms: Sequence[str],
    default: str,
    repair: Callable[[RepairRequest], Repaired],
) -> None:
    """Repair, write, and print all changes. `forms`: writable formats."""
    watch = Stopwatch()
    if request.rule not in RULES:
        what = f"there is no rule {request.rule[:40]!r}"
        raise Refusal(what, "--rule", choice(request.rule, RULES))
    target = target_of(request.output, request.form, forms, default, request.json)
    _refuse_for_drawings(request)
    with memory_wall(request.memory, "the repair", request.file, SIMPLER):
        found = repair(request)
        if target is not None and found.file is not None:
            refuse_overwriting(target.path, [found.file])
        if target is not None and _write(target, found):
            return
    value = document(
        "repair",
        watch,
        dimension=found.dimension,
        operand=request.file,
        rule=request.rule,
        weld=None if request.weld is None else str(request.weld),
        changes=[change.document() for change in found.changes],
        **found.measures,
        warnings=found.warnings,
        output=None if request.output is None else str(request.output),
        output_exact=None if target is None else not found.changes or found.is_exact(target.form),
    )
    give(value, request.json, _print)


def _refuse_for_drawings(request: RepairRequest) -> None:
    """Refuse drawing options beside another operand."""
    given = [
        option
        for option, value in (("--tolerance", request.tolerance), ("--layer", request.layer))
        if value is not None
    ]
    if given and not is_drawing(Path(request.file)):
        them = "it" if len(given) == 1 else "them"
        what = "the operand is no drawing (.dxf, .svg)"
        raise Refusal(what, ", ".join(given), f"leave {them} out")


def _write(target: Target, found: Repaired) -> bool:
    """Write the operand: the file's own bytes if nothing is to be changed, neither the format."""
    file = found.file
    if not found.changes and file is not None and file.suffix.lower() == f".{target.form}":
        data = bytes_of_file(file, escaped(str(file)), "name a file that you may read")
        if target.is_standard_output:
            sys.stdout.flush()
            sys.stdout.buffer.write(data)
            sys.stdout.buffer.flush()
        else:
            write_together({target.path: data})
        return target.is_standard_output
    text = refusing(target.name, lambda: found.write(target.form))
    is_exact = found.is_exact(target.form)
    if not is_exact:
        _refuse_spoiled(text, target, found)
    return target.write(text, is_exact)


def _refuse_spoiled(text: str, target: Target, found: Repaired) -> None:
    """Refuse a format that cannot hold the operand: read again, it would have faults."""
    try:
        found.check(text, target.form)
    except _core.BadInput as error:
        raise Refusal(
            f"as {target.form} the operand would have faults again: {error.problem}",
            target.name,
            "name a .json file, which is exact",
            "not-representable",
        ) from error


def _print(value: dict[str, Any]) -> None:
    changes = value["changes"]
    for change in changes[:MOST_TOLD]:
        sys.stdout.write(f"{escaped(told(change))}\n")
    if len(changes) > MOST_TOLD:
        sys.stdout.write(f"and {len(changes) - MOST_TOLD:,} more: --json has all\n")
    size = "area" if value["volume"] is None else "volume"
    rows = [
        ("changes", f"{len(changes):,}" if changes else "no changes"),
        (size, measure(value[size])),
        *written_row(value),
        ("seconds", f"{value['seconds']:.3f}"),
    ]
    print_lines(rows, value)
