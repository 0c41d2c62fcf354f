"""`minkref verify`: implementations against the exact reference, every disagreement with a
witness."""

from __future__ import annotations

import inspect
from typing import Any

import typer
from minkref.cli.request import fields_of, request_of, signed
from minkref.cli.settings import is_outdone, naming_settings
from minkref.cli.verb import SCHEMA
from minkref.verbs.verify_request import ORDER, Asked, Bounds, Cases, Output, VerifyRequest

EXAMPLES = """Examples:

minkref verify

minkref verify ./my_adapter.py --seconds 60 --report build/report

minkref verify py:my_module:my_sum --junit junit.xml --sarif verify.sarif

minkref verify cgal-reduced --family holes --family comb --pairs 1000 --seed 7

minkref verify cgal-reduced --case random:1:42 --case disc1+cells1815@7/5

minkref verify clipper2 --baseline known.json --ledger run.jsonl --json

minkref verify minkref --pairs 300 --no-models"""

TOLD = """\
Test implementations against the exact reference. Cases: seeded families of generated pairs,
small ones first, with probes at their events, laws, and mutants of those that show something
new; then the included models, and the paper's kind of input at five scales."""


def _verify(context: typer.Context, **values: Any) -> None:
    if is_outdone(context, "pairs", by="seconds"):
        values["pairs"] = None
    from minkref.verbs.verify_run import answer  # all judges, which --help does not need

    parts = (request_of(part, values) for part in (Asked, Cases, Bounds, Output))
    answer(context, VerifyRequest(*parts), command)


FIELDS = {each.name: each for part in (Asked, Cases, Bounds, Output) for each in fields_of(part)}
CONTEXT = inspect.Parameter("context", inspect.Parameter.KEYWORD_ONLY, annotation=typer.Context)
command = naming_settings(
    signed(_verify, TOLD, [CONTEXT, *(FIELDS[name].parameter for name in ORDER), SCHEMA])
)
