"""Texts of others in Markdown."""

from __future__ import annotations

import re

from minkref.terminal import shown


def plain(text: str) -> str:
    """One line in which nothing is markup, of the dialect of GitHub neither: a name of somebody is
    not mentioned, and an address is no link."""
    escaped = shown(text).replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
    escaped = re.sub(r"([\\`*_~\[\]|#!])", r"\\\1", escaped)
    escaped = escaped.replace("@", "&#64;").replace("://", "&#58;//")
    return re.sub(r"\bwww\.", "www&#46;", escaped, flags=re.IGNORECASE)
