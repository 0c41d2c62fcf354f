"""The command line: `python3 -m slow COMMAND P Q ...` from the folder that holds this package."""

from __future__ import annotations

import argparse
import json
import os
import sys
from collections.abc import Callable, Sequence
from fractions import Fraction

from .canonical import document
from .claim import check_claim
from .exact import InputError, Point, number, positive, text_of
from .identity import Link
from .minkowski import Sum, minkowski_sum
from .operand import Operand
from .reader import read_operand
from .state import State
from .topology import topology
from .witness import Meeting, witness

Document = dict[str, object]
EXAMPLES = """examples:
  python3 -m slow sum P.wkt Q.poly --scale 7/5
  python3 -m slow topology case.json#P case.json#Q --scale 541/186 --json
  python3 -m slow tight frame.wkt square.wkt
  python3 -m slow witness P.json Q.json --at 1/3,2
  python3 -m slow compare P.json Q.json --scale 2 --with sum.json

exit codes: 0 all well, 1 the set that was compared is another one, 2 wrong usage or bad input
"""


def point_text(point: Point | None) -> list[str] | None:
    return None if point is None else [text_of(point[0]), text_of(point[1])]


def tight_document(found: Sum) -> list[Document]:
    return [{"points": [point_text(point) for point in piece]} for piece in found.tight]


def run_sum(P: Operand, Q: Operand, scale: Fraction, options: argparse.Namespace) -> Document:
    found = minkowski_sum(P, Q, scale)
    return {
        "digest": found.digest,
        "area": text_of(found.area),
        "components": found.components,
        "holes": found.holes,
        "vertices": sum(len(ring) for ring in Operand(found.polygons, []).rings()),
        "result": document(found.polygons),
        "tight_passages": tight_document(found),
    }


def state_document(state: State) -> Document:
    return {
        "components": len(state.interior),
        "holes": len(state.complement),
        "area": [text_of(part) for part in state.area],
        "shape": state.shape,
        "pinches": state.pinches,
    }


def link_document(link: Link) -> Document:
    return {"change": link.change, "below": link.below, "parts": len(link.at), "above": link.above}


def run_topology(P: Operand, Q: Operand, scale: Fraction, options: argparse.Namespace) -> Document:
    found = topology(P, Q, scale)
    return {
        "boundary_changes": found.boundary_changes,
        "topology_changes": found.topology_changes,
        "digest": found.result.digest,
        "below": state_document(found.below),
        "at": state_document(found.at),
        "above": state_document(found.above),
        "holes": [link_document(link) for link in found.holes],
        "components": [link_document(link) for link in found.components],
        "tight_passages": tight_document(found.result),
    }


def run_tight(P: Operand, Q: Operand, scale: Fraction, options: argparse.Namespace) -> Document:
    return {"tight_passages": tight_document(minkowski_sum(P, Q, scale))}


def point_of(text: str) -> Point:
    parts = text.split(",")
    if len(parts) != 2:
        raise InputError(f"--at takes two numbers with a comma between, not {text!r}")
    return number(parts[0].strip()), number(parts[1].strip())


def meeting_document(meeting: Meeting) -> Document:
    return {"contact": meeting.contact, "p": point_text(meeting.p), "q": point_text(meeting.q)}


def run_witness(P: Operand, Q: Operand, scale: Fraction, options: argparse.Namespace) -> Document:
    at = point_of(options.at)
    return {"point": point_text(at), **meeting_document(witness(P, Q, scale, at))}


def run_compare(P: Operand, Q: Operand, scale: Fraction, options: argparse.Namespace) -> Document:
    found = check_claim(P, Q, scale, read_operand(options.other, validate=False))
    answer: Document = {"equal": found.equal, "canonical": found.canonical}
    if found.proof is not None:
        answer["witness"] = {
            "point": point_text(found.point),
            "in_truth": found.in_truth,
            **meeting_document(found.proof),
        }
    return answer


COMMANDS: dict[str, tuple[Callable[..., Document], str]] = {
    "sum": (run_sum, "the sum sP + Q in canonical form, with its digest"),
    "topology": (run_topology, "the sum at, just below and just above a scale, and what changes"),
    "tight": (run_tight, "the tight passages at a scale"),
    "witness": (run_witness, "how sP and x - Q meet"),
    "compare": (run_compare, "whether a file holds the sum; if not, a point of the difference"),
}


def parser() -> argparse.ArgumentParser:
    top = argparse.ArgumentParser(
        prog="slow",
        description="Exact Minkowski sums sP + Q from their definition, in plain Python.",
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    commands = top.add_subparsers(dest="command", required=True, metavar="COMMAND")
    for name, (_, about) in COMMANDS.items():
        command = commands.add_parser(
            name,
            help=about,
            description=about,
            epilog=EXAMPLES,
            formatter_class=argparse.RawDescriptionHelpFormatter,
        )
        command.add_argument("P", help="the operand that is scaled: .json, .json#P, .wkt, .poly")
        command.add_argument("Q", help="the other operand")
        command.add_argument("--scale", default="1", metavar="S", help="3, 7/5, 0.25; default 1")
        command.add_argument("--json", action="store_true", help="one JSON document")
        if name == "witness":
            command.add_argument(
                "--at",
                required=True,
                metavar="X,Y",
                help="the point x; --at=-1,2 where it begins with a minus",
            )
        if name == "compare":
            command.add_argument("--with", required=True, dest="other", metavar="FILE")
    return top


def lines(value: object, name: str = "") -> list[str]:
    """Format the document for reading: one line per entry, compact below the first level."""
    if isinstance(value, dict) and not name:
        return [line for key, entry in value.items() for line in lines(entry, str(key))]
    text = value if isinstance(value, str) else json.dumps(value, separators=(",", ":"))
    return [f"{name}: {text}"]


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command and return the exit code; usage errors raise SystemExit(2)."""
    options = parser().parse_args(arguments)
    # Input numbers are bounded; results may have any number of digits.
    sys.set_int_max_str_digits(0)
    run, _ = COMMANDS[options.command]
    try:
        scale = positive(options.scale)
        answer = run(read_operand(options.P), read_operand(options.Q), scale, options)
    except InputError as error:
        if options.json:
            print(json.dumps({"command": options.command, "error": str(error)}))
        print(f"slow: {error}", file=sys.stderr)
        return 2
    if options.json:
        text = json.dumps({"command": options.command, "scale": text_of(scale), **answer})
    else:
        text = "\n".join(lines(answer))
    try:
        print(text, flush=True)
    except OSError as error:  # the reader has gone, or the disk is full
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        print(f"slow: cannot write the answer: {error.strerror}", file=sys.stderr)
        return 2
    return 0 if answer.get("equal", True) else 1
