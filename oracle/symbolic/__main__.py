"""The command: python3 -m symbolic, from the folder `oracle`."""

from __future__ import annotations

import argparse
import json
import os
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from . import documents, solutions

SEGMENTS = """{"segments": [{"kind": "S", "edge": [["0","0"],["1","0"]], "vertex": ["0","0"]},
              {"kind": "T", "edge": [["2","-1"],["2","1"]], "vertex": ["1/2","0"]}]}"""
LEVEL = """{"segments": [{"kind": "T", "edge": [[0,0],[2,0]], "vertex": [0,0]},
              {"kind": "T", "edge": [[5,0],[6,0]], "vertex": [-1,0]}]}"""
THREE = """{"segments": [{"kind": "T", "edge": [[0,20],[17,-11]], "vertex": [-3,-2]},
              {"kind": "T", "edge": [[17,-11],[-19,-9]], "vertex": [1,3]},
              {"kind": "T", "edge": [[-19,-9],[0,20]], "vertex": [4,-1]}]}"""
FACETS = """{"facets": [{"kind": "fv", "P": [[0,0,1],[6,0,1],[0,6,1]], "Q": [[0,0,0]]}],
  "vertex": {"p": [0,0,-1], "q": [1,1,10]}}

Two facets without a vertex: their planes; four: one point of all. Two edges:

 {"edges": [{"kind": "S", "P": [[0,0,0],[0,1,1]], "Q": [[0,0,0]]},
            {"kind": "T", "P": [[0,0,0]], "Q": [[0,2,2],[0,3,3]]}]}"""
DISC = """{"polygon": [[0,0],[12,0],[12,6],[8,6],[8,2],[4,2],[4,6],[0,6]], "radius": "1"}

The ring runs counter-clockwise; "s" is a sum of square roots."""

Answer = Callable[[documents.Document], documents.Document]
COMMANDS: dict[str, tuple[Answer, str, str]] = {
    "pair": (documents.answer_pair, "when two segments meet that are not parallel", SEGMENTS),
    "parallel": (documents.answer_parallel, "events of two parallel segments", LEVEL),
    "triple": (documents.answer_triple, "when three segments share a point", THREE),
    "facets": (documents.answer_facets, "facets, vertices and edges in space", FACETS),
    "disc": (documents.answer_disc, "a disc of radius s r swept along a polygon", DISC),
}


def parser() -> argparse.ArgumentParser:
    root = argparse.ArgumentParser(
        prog="python3 -m symbolic",
        description="Event scales from the definitions, exact. Reads JSON, prints JSON.",
        epilog="Exit codes: 0 all well, 2 wrong usage or bad input.\n\nExample:\n"
        f"  echo '{SEGMENTS}' |\n  python3 -m symbolic pair",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    commands = root.add_subparsers(dest="command", required=True)
    derive = commands.add_parser(
        "derive",
        help="derive the general solutions again and keep them",
        description="Derives all general solutions by sympy and writes solutions.json.",
        epilog="Example:\n  python3 -m symbolic derive -o /tmp/solutions.json",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    derive.add_argument("-o", "--output", type=Path, default=solutions.FILE, metavar="FILE")
    for name, (_, about, example) in COMMANDS.items():
        command = commands.add_parser(
            name,
            help=about,
            description=f"{about}; exact.".capitalize(),
            epilog=f"Example of a request:\n {example}",
            formatter_class=argparse.RawDescriptionHelpFormatter,
        )
        command.add_argument("request", nargs="?", default="-", help="a JSON file; - reads it")
    return root


def answered(name: str, path: str) -> dict[str, Any]:
    source = sys.stdin.read() if path == "-" else Path(path).read_text(encoding="utf-8")
    request = documents.parsed(source)
    try:
        return COMMANDS[name][0](request)
    except KeyError as error:
        raise documents.RequestError(f"the request has no member {error}") from error
    except TypeError as error:
        raise documents.RequestError(
            f"the request has a member of another type: {error}"
        ) from error


def main(arguments: Sequence[str] | None = None) -> int:
    asked = parser().parse_args(arguments)
    try:
        if asked.command == "derive":
            document = solutions.derive()
            solutions.write(document, asked.output)
            answer = {"output": str(asked.output), "solutions": len(document["solutions"])}
        else:
            answer = answered(asked.command, asked.request)
    except RecursionError:
        print(f"{asked.command}: the request nests too deeply", file=sys.stderr)
        return 2
    except (OSError, ValueError, solutions.SolutionsError) as error:
        print(f"{asked.command}: {error}", file=sys.stderr)
        return 2
    try:
        print(json.dumps(answer, indent=1), flush=True)
    except OSError as error:  # the reader has gone, or the disk is full
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        print(f"{asked.command}: cannot write the answer: {error.strerror}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
