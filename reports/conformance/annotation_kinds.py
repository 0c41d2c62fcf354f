"""Where `minkref verify` writes annotations: apart from them, for the command's options need no
judges."""

from __future__ import annotations

from minkref.errors import Refusal, choice

AUTO, GITHUB, NONE = "auto", "github", "none"
KINDS = (AUTO, GITHUB, NONE)


def check_annotations(kind: str) -> None:
    """Refuses other kinds than `auto`, `github` and `none`."""
    if kind not in KINDS:
        what = f"there are no annotations of the kind {kind[:40]!r}"
        raise Refusal(what, "--annotations", choice(kind, KINDS))
