"""`minkref adapter check`: a few sums that show whether an adapter works, and what it declares."""

from __future__ import annotations

import json as texts
from dataclasses import dataclass
from fractions import Fraction
from typing import Annotated, Any

import typer
from minkref.cli.options import Json, Schema
from minkref.cli.output import give, plain_table
from minkref.cli.target_options import (
    CallMemory,
    CallProcesses,
    CallSeconds,
    IsolationKind,
    PassedVariables,
    walls_and_limits,
)
from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.cases.verbs import FEATURES, INSET, OFFSET, PATH, RANGES, UNION
from minkref.fuzz.cases.verbs import LINES as LINES_WORD
from minkref.fuzz.isolation.isolation import AUTO, Isolation
from minkref.fuzz.offsets.manner import Manner
from minkref.fuzz.run.declared import declarations_of
from minkref.fuzz.shrink.asker import Asker
from minkref.fuzz.space.cells import Cell, surface_of
from minkref.fuzz.targets.answer import PROCESSES
from minkref.fuzz.targets.declaration import CAPABILITIES, NO_SUMS, Declaration
from minkref.fuzz.verdicts.verdict import BROKEN, Outcome, Verdict
from minkref.output.documents import Stopwatch, document
from minkref.output.exits import ExitCode
from minkref.output.signals import ending_in_order
from minkref.output.terminal import console, escaped
from minkref.reports.conformance.run_words import witness_text

EXAMPLES = """Examples:

minkref adapter check ./my_library_adapter

minkref adapter check py:my_module:my_sum --json"""

TRIANGLE = '{"polygons":[{"outer":[["0","0"],["2","0"],["0","2"]],"holes":[]}]}'
SQUARE = '{"polygons":[{"outer":[["0","0"],["1","0"],["1","1"],["0","1"]],"holes":[]}]}'
HOOK = (
    '{"polygons":[{"outer":[["0","0"],["4","0"],["4","4"],["3","4"],["3","1"],["0","1"]],'
    '"holes":[]}]}'
)
FRAME = (
    '{"polygons":[{"outer":[["0","0"],["4","0"],["4","4"],["0","4"]],'
    '"holes":[[["1","1"],["1","3"],["3","3"],["3","1"]]]}]}'
)
BLOCK = [(x, y, z) for x in range(3) for y in range(3) for z in range(3)]


@dataclass(frozen=True)
class Trying:
    """A question: P, Q and the scale as a case that names itself."""

    title: str
    P: str
    Q: str
    scale: str = "1"
    path: dict[str, Any] | None = None  # a question about one, P being the part
    others: tuple[str, ...] | None = None  # a question about the union of P, Q and these
    radius: str | None = None  # a question about P grown by a disc
    verb: str = OFFSET  # of P and a radius
    manner: Manner = Manner()  # noqa: RUF009 a frozen value

    @property
    def literal(self) -> str:
        if self.path is not None:
            value = {"part": texts.loads(self.P), "obstacles": texts.loads(self.Q), **self.path}
            return texts.dumps(value, separators=(",", ":"))
        if self.others is not None:
            sets = [texts.loads(text) for text in (self.P, self.Q, *self.others)]
            return texts.dumps({"sets": sets}, separators=(",", ":"))
        if self.radius is not None:
            value = {self.verb: texts.loads(self.P), "radius": self.radius}
            value |= self.manner.members()
            return texts.dumps(value, separators=(",", ":"))
        value = {"P": texts.loads(self.P), "Q": texts.loads(self.Q), "scale": self.scale}
        return texts.dumps(value, separators=(",", ":"))


IN_PLANE = [
    Trying("a triangle and a square", TRIANGLE, SQUARE),
    Trying("the same, the triangle doubled", TRIANGLE, SQUARE, "2"),
    Trying("a hook and a triangle: the hook is not convex", HOOK, TRIANGLE),
    Trying("a frame and a square: the hole becomes smaller", FRAME, SQUARE),
]


PART = '{"polygons":[{"outer":[["2","0"],["3","0"],["3","1"],["2","1"]],"holes":[]}]}'
WALLS = (
    '{"polygons":[{"outer":[["1","0"],["4","0"],["4","1"],["1","1"]],"holes":[]},'
    '{"outer":[["6","0"],["9","0"],["9","1"],["6","1"]],"holes":[]}]}'
)
WAY: dict[str, Any] = {"path": [["0", "0"], ["0", "1/2"]]}
SCALES = {"scales": ["1/4", "1", "2", "3", "9/2", "5"]}
ON_PATHS = [
    Trying("a part on a path: it may touch, at 2 it passes", PART, WALLS, "1",
           {**WAY, "contact": "allowed", **SCALES}),
    Trying("the same, and it must not touch", PART, WALLS, "1",
           {**WAY, "contact": "forbidden", **SCALES}),
]  # fmt: skip
ALL_ON_PATHS = [
    Trying("all scales from 1/8 to 8, one of them alone", PART, WALLS, "1",
           {**WAY, "contact": "allowed", "from": "1/8", "to": "8"}),
]  # fmt: skip

BESIDE = '{"polygons":[{"outer":[["2","0"],["4","0"],["4","1"],["2","1"]],"holes":[]}]}'
INSIDE = '{"polygons":[{"outer":[["1","1"],["3","1"],["3","3"],["1","3"]],"holes":[]}]}'
UNIONS = [
    Trying("the union of a triangle and a square", TRIANGLE, SQUARE, others=()),
    Trying("of a triangle and a box that touch at a vertex", TRIANGLE, BESIDE, others=()),
    Trying("of a frame and two boxes: one fills the hole", FRAME, INSIDE, others=(BESIDE,)),
]

OFFSETS = [
    Trying("a triangle grown by a disc", TRIANGLE, "", radius="1"),
    Trying("a frame: the hole becomes smaller", FRAME, "", radius="1/2"),
    Trying("a frame: the hole is filled", FRAME, "", radius="3/2"),
]

LINE = '{"lines":[[["0","0"],["4","0"],["4","3"]]]}'
INSETS = [
    Trying("a frame eroded by a disc: the hole grows", FRAME, "", radius="-1/4"),
    Trying("a hook: all of it vanishes", HOOK, "", radius="-1"),
]
LINES = [Trying("an open line grown by a disc", LINE, "", radius="1/2")]
WITH_MANNERS = {
    capability: Trying(title, P, "", radius="1", manner=manner)
    for capability, title, P, manner in (
        ("join-mitre", "a hook with mitred corners", HOOK, Manner("mitre", limit=Fraction(2))),
        ("join-bevel", "a hook with bevelled corners", HOOK, Manner("bevel")),
        ("join-square", "a hook with squared corners", HOOK, Manner("square")),
        ("join-sharp", "a hook with sharp corners", HOOK, Manner("sharp")),
        ("cap-flat", "a line with flat ends", LINE, Manner(cap="flat")),
        ("cap-square", "a line with squared ends", LINE, Manner(cap="square")),
    )
}

OF_FEATURES = [
    Trying("features of a triangle: none", TRIANGLE, "", radius="1", verb=FEATURES),
    Trying("of a hook: one bay", HOOK, "", radius="1", verb=FEATURES),
    Trying("of a frame: four corners, one hole", FRAME, "", radius="1/2", verb=FEATURES),
]


def _solid(*cells: Cell) -> str:
    return surface_of(frozenset(cells)).to_json()


IN_SPACE = [
    Trying("two cubes", _solid((0, 0, 0)), _solid((0, 0, 0))),
    Trying("the same, the first doubled", _solid((0, 0, 0)), _solid((0, 0, 0)), "2"),
    Trying(
        "a hook and a cube: the hook is not convex",
        _solid((0, 0, 0), (1, 0, 0), (0, 1, 0)),
        _solid((0, 0, 0)),
    ),
    Trying(
        "a hollow cube and half a cube: the hole becomes smaller",
        _solid(*(cell for cell in BLOCK if cell != (1, 1, 1))),
        surface_of(frozenset({(0, 0, 0)})).scaled(Fraction(1, 2)).to_json(),
    ),
]


def command(
    target: Annotated[
        str,
        typer.Argument(
            help="What to check, as for `minkref verify`: ./PATH, cmd:COMMAND, py:module:function, "
            "so:./library.so:function, or a name of `minkref targets`.",
            metavar="TARGET",
        ),
    ],
    call_seconds: CallSeconds = 30.0,
    call_memory: CallMemory = 4096,
    call_processes: CallProcesses = PROCESSES,
    isolation: IsolationKind = AUTO,
    pass_env: PassedVariables = None,
    json: Json = False,
    schema: Schema = False,
) -> None:
    """Start an adapter, show what it declares and what that leaves out, and ask for four sums: two
    of convex operands, one of an operand that is not convex, and one with a hole; and for paths,
    unions, offsets, insets, lines, joins, caps and features, if it declares them. Exits with 1 if
    an answer is proven wrong, 3 if the adapter breaks, and 2 if it does not start."""
    watch = Stopwatch()
    walls, limits = walls_and_limits(call_seconds, call_memory, call_processes, isolation, pass_env)
    chosen = [ALL_TARGETS.select_one(target)]
    (entry,), declarations = declarations_of(chosen, ALL_TARGETS, limits)
    declared = declarations[entry.name]
    able = declared.capabilities
    asked = {"plane": IN_PLANE, "space": IN_SPACE} if declared.makes_sums else {}
    asked |= {PATH: ON_PATHS, RANGES: ALL_ON_PATHS, UNION: UNIONS, OFFSET: OFFSETS}
    asked |= {INSET: INSETS, LINES_WORD: LINES, FEATURES: OF_FEATURES}
    asked |= {word: [trying] for word, trying in WITH_MANNERS.items()}
    trials = [trying for word, some in asked.items() if word in able for trying in some]
    with ending_in_order(), Asker(entry.name, ALL_TARGETS, limits) as asker:
        rows = [(trying, asker.ask(trying.literal)[1]) for trying in trials]
    code = _exit_code([outcome for _, outcome in rows])
    value = document(
        "adapter_check",
        watch,
        exit_code=int(code),
        target={"name": entry.name, "version": entry.version, **_declared(declared)},
        isolation=walls.document(),
        left_out={word: CAPABILITIES[word] for word in sorted(set(CAPABILITIES) - able)},
        sums=[_row(trying, outcome) for trying, outcome in rows],
    )
    give(value, json, lambda value: _print(value, rows, walls))
    if code:
        raise typer.Exit(int(code))


def _exit_code(outcomes: list[Outcome | None]) -> ExitCode:
    verdicts = {outcome.verdict for outcome in outcomes if outcome}
    if Verdict.WRONG in verdicts:
        return ExitCode.WRONG
    return ExitCode.BROKEN if verdicts & set(BROKEN) else ExitCode.ALL_WELL


def _declared(declared: Declaration) -> dict[str, Any]:
    return {
        "arithmetic": declared.arithmetic,
        "numbers": declared.numbers,
        "tolerance": declared.tolerance_document(),
        "sum": declared.sum,
        "capabilities": sorted(declared.capabilities),
    }


def _sums(word: str) -> str:
    return "no sums" if word == NO_SUMS else f"sum of the {word}"


def _row(trying: Trying, outcome: Outcome | None) -> dict[str, Any]:
    witness = outcome.witness.document() if outcome and outcome.witness else None
    return {
        "what": trying.title,
        "case": trying.literal,
        "verdict": str(outcome.verdict) if outcome else "skipped",
        "reasons": [str(reason) for reason in outcome.reasons] if outcome else [],
        "message": outcome.message if outcome else "",
        "witness": witness,
        "seconds": round(outcome.seconds, 6) if outcome else 0,
    }


def _print(
    value: dict[str, Any], rows: list[tuple[Trying, Outcome | None]], walls: Isolation
) -> None:
    out = console()
    target = value["target"]
    version = f" {target['version']}" if target["version"] else ""
    out.print(escaped(f"{target['name']}{version} begins, and answers"), soft_wrap=True)
    tolerance = target["tolerance"]
    out.print(
        escaped(
            f"  arithmetic {target['arithmetic']}, numbers as {target['numbers']}, tolerance "
            f"{tolerance['absolute']} + {tolerance['relative']} of the size, {_sums(target['sum'])}"
        ),
        soft_wrap=True,
    )
    out.print(f"  takes: {', '.join(target['capabilities'])}", soft_wrap=True)
    out.print(escaped(f"  {walls.sentence()}"), soft_wrap=True)
    table = plain_table("sum", "verdict", "seconds")
    for row in value["sums"]:
        table.add_row(row["what"], row["verdict"], f"{row['seconds']:.3f}")
    out.print(table)
    for trying, outcome in rows:
        if outcome is not None and (outcome.message or outcome.witness):
            said = outcome.message or ", ".join(outcome.kinds)
            out.print(escaped(f"{trying.title}: {said}"), soft_wrap=True)
            if outcome.witness is not None:
                out.print(
                    escaped(f"  {witness_text(outcome.witness, trying.scale)}"), soft_wrap=True
                )
    if value["left_out"]:
        out.print("Not declared, so cases that need it are skipped:")
        for word, need in value["left_out"].items():
            out.print(f"  {word}: {need}", soft_wrap=True)
