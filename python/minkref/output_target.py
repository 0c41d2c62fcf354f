"""Where a command writes a set, and in which format."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from minkref.documents import check_writable, write_atomically
from minkref.errors import Refusal, choice

STANDARD_OUTPUT = Path("-")


@dataclass(frozen=True)
class Target:
    path: Path
    form: str

    @property
    def name(self) -> str:
        return "standard output" if self.path == STANDARD_OUTPUT else str(self.path)

    def write(self, text: str, exact: bool) -> bool:
        """True where it was standard output, to which nothing else is written then; where the text
        is rounded, and no picture, a warning says so."""
        if self.path != STANDARD_OUTPUT:
            write_atomically(self.path, text)
            return False
        sys.stdout.write(text if text.endswith("\n") else text + "\n")
        if not exact and self.form != "svg":
            sys.stderr.write("warning: standard output is rounded; json is exact\n")
        return True


def target_of(
    output: Path | None, form: str | None, forms: Sequence[str], default: str, json: bool
) -> Target | None:
    """None where nothing is to be written. Refuses a format that is none of `forms`, a place that
    cannot be written, and standard output for two things."""
    if output is None:
        if form is not None:
            raise Refusal("there is nothing to write", f"--format {form}", "add -o FILE, or -o -")
        return None
    if form is not None and form not in forms:
        mend = choice(form, forms)
        raise Refusal("there is no such format", f"--format {form[:40]}", mend)
    if output == STANDARD_OUTPUT:
        if json:
            what = "standard output takes the result or the document, not both"
            raise Refusal(what, "-o - --json", "leave out one of the two")
        return Target(output, form or default)
    ending = output.suffix.lower().removeprefix(".")
    if form is None and ending not in forms:
        raise Refusal(
            f"the ending {output.suffix or '(none)'} names no format that can be written",
            str(output),
            f"choose one of {', '.join(f'.{one}' for one in forms)}, or add --format",
        )
    check_writable(output)
    return Target(output, form or ending)
