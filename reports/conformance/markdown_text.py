"""Other people's texts in Markdown."""

from __future__ import annotations

import re

from minkref.output.terminal import escaped


def plain(text: str) -> str:
    """One line without markup, GitHub's dialect included: names are not mentioned, and addresses
    are no links."""
    text = escaped(text).replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
    text = re.sub(r"([\\`*_~\[\]|#!])", r"\\\1", text)
    text = text.replace("@", "&#64;").replace("://", "&#58;//")
    return re.sub(r"\bwww\.", "www&#46;", text, flags=re.IGNORECASE)
