"""Words that docs and reports put into the paper's mouth are the paper's own: what stands between “
and ” is in `quotations.toml`, and sentences that say what the paper says quote it."""

from __future__ import annotations

import ast
import os
import re
import tomllib
from collections.abc import Iterator
from pathlib import Path

import pytest
from minkref.reports.audit.catalogue import ENTRIES
from minkref.reports.audit.page import ROOT
from minkref.reports.paper.kept_run import kept

QUOTATIONS: dict[str, list[str]] = tomllib.loads(
    (Path(__file__).parent / "quotations.toml").read_text(encoding="utf-8")
)
PAPER = os.environ.get("MINKREF_PAPER")
#: The paper's title, and words of ours that the audit's page explains.
NOT_THE_PAPERS = ("Dynamic Minkowski Sums Under Scaling", "False as read literally", "false")
PAGES = sorted(
    path
    for folder, kinds in (("docs", ("md",)), ("reports/paper", ("py", "j2")),
                          ("reports/audit", ("py", "j2")), ("reports/bench", ("py",)))
    for kind in kinds
    for path in (ROOT / folder).rglob(f"*.{kind}")
)  # fmt: skip
SAYS = re.compile(r"\b[Tt]he paper(?: itself)? (?:says|states|said|claims|asserts)\b")


def plain(text: str) -> str:
    """Without spaces, hyphens and quotation marks, which breaks of lines and columns change."""
    return re.sub(r"[\s\-‐–—“”\"'’*]", "", text).lower()


SAID = [plain(sentence) for sentences in QUOTATIONS.values() for sentence in sentences]


def quoted(text: str) -> Iterator[str]:
    for words in re.findall(r"“([^”{]*)”", text):
        if words not in (*NOT_THE_PAPERS, "…"):
            yield words.rstrip(".")


@pytest.mark.parametrize("path", PAGES, ids=lambda path: str(path.relative_to(ROOT)))
def test_what_stands_in_quotation_marks_is_the_papers(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".py":  # without the quotes and breaks of its strings
        text = " ".join(
            node.value for node in ast.walk(ast.parse(text))
            if isinstance(node, ast.Constant) and isinstance(node.value, str)
        )  # fmt: skip
    strange = [words for words in quoted(text) if not any(plain(words) in one for one in SAID)]
    assert strange == []


@pytest.mark.parametrize("path", PAGES, ids=lambda path: str(path.relative_to(ROOT)))
def test_a_sentence_on_what_the_paper_says_quotes_it(path: Path) -> None:
    text = " ".join(path.read_text(encoding="utf-8").split())
    sentences = re.split(r"(?<=[.!?]) ", text)
    assert [one for one in sentences if SAYS.search(one) and "“" not in one] == []


def test_an_entry_of_the_audit_quotes_in_the_papers_marks() -> None:
    """So that the test above sees each quotation."""
    assert [name for name, entry in ENTRIES.items() if '"' in entry.printed] == []


def claims() -> Iterator[ast.Call]:
    for path in (ROOT / "reports/paper").glob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "Claim":
                yield node


def test_each_claim_of_the_report_is_in_the_papers_words() -> None:
    texts = [
        text.value
        for call in claims()
        for text in ast.walk(call.args[0])
        if isinstance(text, ast.Constant) and isinstance(text.value, str) and len(text.value) > 9
    ]
    assert len(texts) > 15
    assert [text for text in texts if not any(plain(text) in one for one in SAID)] == []


def test_each_claim_of_the_kept_run_is_in_the_words_of_its_section() -> None:
    run = kept()
    assert run is not None  # reports/paper/kept_run.json
    claims = [claim for entry in run["entries"] for claim in entry["claims"]]
    assert len(claims) >= 20
    for claim in claims:
        said = [plain(sentence) for sentence in QUOTATIONS[claim["place"]]]
        assert any(plain(claim["words"]) in one for one in said), claim["words"]


@pytest.mark.skipif(PAPER is None, reason="MINKREF_PAPER names no text of the paper")
def test_each_quotation_is_in_the_paper() -> None:
    assert PAPER is not None
    text = plain(Path(PAPER).read_text(encoding="utf-8"))
    missing = [one for sentences in QUOTATIONS.values() for one in sentences
               if plain(one) not in text]  # fmt: skip
    assert missing == []
