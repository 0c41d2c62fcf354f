"""The place to which a command writes, and the format."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

from minkref.errors import Refusal, choice
from minkref.output.documents import check_writable, descriptor_of, is_stream, writing

STANDARD_OUTPUT = Path("-")


@dataclass(frozen=True)
class Target:
    path: Path
    form: str

    @property
    def name(self) -> str:
        return "standard output" if self.is_standard_output else str(self.path)

    @property
    def is_standard_output(self) -> bool:
        """Tell whether standard output takes the text; nothing else is written there then."""
        return self.path == STANDARD_OUTPUT

    @contextmanager
    def stream(self) -> Iterator[BinaryIO]:
        """Open the target for writing: replaces a file once all is written, or not at all."""
        if not self.is_standard_output:
            with writing(self.path) as stream:
                yield stream
            return
        sys.stdout.flush()
        yield sys.stdout.buffer
        sys.stdout.buffer.flush()

    def write_pieces(self, pieces: Iterable[str]) -> int:
        """Write a text piece by piece; return the byte count."""
        count = 0
        with self.stream() as stream:
            for piece in pieces:
                data = piece.encode(errors="backslashreplace")
                stream.write(data)
                count += len(data)
        return count

    def write(self, text: str, exact: bool = True) -> bool:
        """Write a text; return True for standard output, which then takes nothing else. Warns on
        standard error about rounded text, except for a picture."""
        ended = text.endswith("\n") or not self.is_standard_output
        self.write_pieces([text] if ended else [text, "\n"])
        self.tell_rounding(exact)
        return self.is_standard_output

    def tell_rounding(self, exact: bool) -> None:
        """Warn if standard output took rounded text, except for a picture."""
        if self.is_standard_output and not exact and self.form != "svg":
            sys.stderr.write("warning: standard output is rounded; json is exact\n")


def refuse_stream(output: Path, what: str, mend: str) -> None:
    """Refuse standard output, pipes and devices for output other than a single text."""
    if output == STANDARD_OUTPUT or is_stream(output):
        raise Refusal(what, f"-o {output}", mend, "cannot-write")


def target_of(
    output: Path | None,
    form: str | None,
    forms: Sequence[str],
    default: str,
    json: bool,
    has_format: bool = True,
    offered: Sequence[str] | None = None,
) -> Target | None:
    """Choose the target; None if nothing is to be written. A pipe, a device or standard output has
    the format `default` unless `form` or an ending names one. Refuses a format outside `forms`, a
    place that cannot be written, and standard output for two things. `has_format`: the command has
    the option --format, which the refusal of an ending then offers; `offered`: the `forms` that fit
    the other options, for refusals."""
    if form is not None and form not in forms:
        mend = choice(form, offered or forms)
        raise Refusal("there is no such format", f"--format {form[:40]}", mend)
    if output is None:
        if form is not None:
            raise Refusal("there is nothing to write", f"--format {form}", "add -o FILE, or -o -")
        return None
    if output == STANDARD_OUTPUT or descriptor_of(output) == 1:
        if json:
            what = "standard output takes the result or the document, not both"
            raise Refusal(what, f"-o {output} --json", "leave out one of the two")
        return Target(STANDARD_OUTPUT, form or default)
    ending = output.suffix.lower().removeprefix(".")
    if form is None and ending not in forms:
        if not is_stream(output):
            raise Refusal(
                f"the ending {output.suffix or '(none)'} names no format that can be written",
                str(output),
                _other_ending(offered or forms, has_format),
            )
        ending = default
    check_writable(output)
    return Target(output, form or ending)


def _other_ending(forms: Sequence[str], has_format: bool) -> str:
    if len(forms) == 1:
        return f"name a file that ends in .{forms[0]}"
    choice = f"choose one of {', '.join(f'.{one}' for one in forms)}"
    return f"{choice}, or add --format {forms[0]}" if has_format else choice
