"""Exit codes of the command line; with several outcomes the worst of 1, 2, 4 counts, in this
order."""

from __future__ import annotations

from enum import IntEnum


class ExitCode(IntEnum):
    ALL_WELL = 0
    WRONG = 1  # a proven `wrong`, a disagreement
    USAGE = 2  # wrong usage, bad input, or nothing selected to run
    BROKEN = 3  # an implementation crashed, hung or broke the protocol; nothing was proven wrong
    UNDECIDED = 4  # `verify --strict` only
    INTERNAL = 70  # an error of ours
    BROKEN_PIPE = 141  # the reader of standard output has gone; as a shell shows SIGPIPE
