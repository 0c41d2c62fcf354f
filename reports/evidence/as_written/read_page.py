"""A page reader: the data that the page's script reads, with numbers as texts."""

from __future__ import annotations

import re

from minkref.reports.evidence.as_written.answers import Answers, Document
from minkref.reports.evidence.as_written.read_plane import load

DATA = re.compile(r'<script id="data" type="application/json">(.*?)</script>', re.S)


def page_data(answers: Answers, *words: object) -> Document:
    """The data from a command's page. Raises ValueError if the page has no data."""
    path = answers.folder / "page.html"
    path.unlink(missing_ok=True)
    answers.table(*words, "-o", path)
    found = DATA.search(answers.read(path))
    if found is None:
        raise ValueError("a page without data")
    value: Document = load(found[1])
    return value
