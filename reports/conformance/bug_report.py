"""A text for a library's issue tracker: Markdown, readable without minkref."""

from __future__ import annotations

import re

from minkref.fuzz.libraries.programs import library
from minkref.fuzz.verdicts.verdict import Verdict
from minkref.output.terminal import escaped
from minkref.reports.conformance.case_view import CaseView, written
from minkref.reports.conformance.feature_words import feature_question
from minkref.reports.conformance.markdown_text import plain
from minkref.reports.conformance.offset_words import offset_question
from minkref.reports.conformance.path_words import path_argument, path_question
from minkref.reports.conformance.union_words import union_question
from minkref.reports.conformance.words import meaning


def bug_report(view: CaseView, version: str | None, presence: list[str]) -> str:
    """Title, versions, input, expected, got, how to reproduce it without minkref, and why the
    expected is right."""
    outcome = view.outcome
    name = library(outcome.target)
    kinds = ", ".join(outcome.kinds)
    lines = [
        f"# {_subject(view)}: {'; '.join(meaning(kind) for kind in outcome.kinds)}",
        "",
        "## Versions",
        "",
        plain(f"- {name} {version or '(version not known)'}, {outcome.target}"),
        *(plain(f"- {line}") for line in presence),
        "",
        "## Input",
        "",
        *_block(_input(view)),
        "",
        "## Expected",
        "",
        *_expected(view),
        "",
        "## Got",
        "",
        *_got(view, kinds),
        "",
        "## To reproduce",
        "",
        *_program(view),
    ]
    if view.argument:
        lines += ["", "## Why the expected is right", "", *(f"- {s}" for s in view.argument)]
    return "\n".join(lines) + "\n"


def _subject(view: CaseView) -> str:
    if view.case.offset is not None:
        return "Offset of a polygon"
    if view.case.features is not None:
        return "Concave features of a polygon"
    return f"Minkowski sum of {'two solids' if view.case.dimension == 3 else 'two polygons'}"


def _input(view: CaseView) -> str:
    scale = view.case.scale
    texts = [f"{name}: {text}" for name, text in view.operand_texts]
    if scale != "1":
        texts.append(f"scale: {scale}. The sum is that of P, scaled about the origin by it, and Q.")
    if view.case.union is not None:
        texts += union_question(view.case.union)
    if view.case.offset is not None:
        texts += offset_question(view.case.offset)
    if view.case.features is not None:
        texts += feature_question(view.case.features)
    if view.case.path is not None:
        texts += ["P is the part, Q the obstacles.", *path_question(view.case.path)]
    return "\n".join(texts)


def _expected(view: CaseView) -> list[str]:
    if view.invalid:
        return [view.refusal]
    witness = view.outcome.witness
    if witness is not None and witness.contact is not None:
        return path_argument(witness)
    lines = _block(written(view.expected)) if view.expected else ["An answer."]
    if view.expected is None and witness is not None:
        lines = []
    if witness is not None:
        side = "has" if witness.in_truth else "does not have"
        lines += ["", f"It {side} the point ({', '.join(witness.point)})."]
    return lines


def _got(view: CaseView, kinds: str) -> list[str]:
    outcome = view.outcome
    lines = _block(written(outcome.got)) if outcome.got else []
    if (outcome.was or outcome.verdict) is not Verdict.WRONG or not outcome.got:
        said = outcome.message if outcome.was is None else ""
        signal = f" ({outcome.signal})" if outcome.signal else ""
        lines.append(f"{kinds}{signal}")
        if said:
            lines += ["", *_block(escaped(said))]
    return lines


def _program(view: CaseView) -> list[str]:
    if view.program is None:
        return [view.no_program]
    language = {"cpp": "c++", "py": "python"}.get(view.program.file.rpartition(".")[2], "")
    return [
        f"`{view.program.file}`:",
        "",
        *_block(view.program.text.rstrip("\n"), language),
        "",
        *_block(view.program.run),
        "",
        "It exits with 1 where the fault shows."
        if view.outcome.witness and not view.invalid
        else "It makes the call, and ends as the call ends.",
        *([view.program.note] if view.program.note else []),
    ]


def _block(text: str, language: str = "") -> list[str]:
    """Fenced, with a fence that the text does not hold."""
    longest = max((len(run) for run in re.findall(r"`{3,}", text)), default=2)
    fence = "`" * (longest + 1)
    return [f"{fence}{language}", *text.split("\n"), fence]
