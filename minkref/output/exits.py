"""Exit codes of the command line; among several outcomes the worst of 1, 2, 4 counts, in this
order."""

from __future__ import annotations

from enum import IntEnum


class ExitCode(IntEnum):
    ALL_WELL = 0
    WRONG = 1  # a proven `wrong`, a disagreement
    USAGE = 2  # wrong usage, bad input, or nothing selected to run
    BROKEN = 3  # an implementation crashed, hung or broke the protocol; nothing was proven wrong
    UNDECIDED = 4  # `verify --strict`, and `check` out of budget
    DECLINED = 5  # `check --proved`
    INTERNAL = 70  # our own error
    INTERRUPTED = 130  # as a shell shows SIGINT
    BROKEN_PIPE = 141  # the reader of standard output has gone; as a shell shows SIGPIPE


#: In the words of `minkref --help`; docs/command-line.md says more.
MEANINGS = {
    ExitCode.ALL_WELL: "success",
    ExitCode.WRONG: "something is proven wrong",
    ExitCode.USAGE: "wrong usage or bad input",
    ExitCode.BROKEN: "an implementation crashed or hung",
    ExitCode.UNDECIDED: "undecided (verify --strict, check)",
    ExitCode.DECLINED: "a claim without a theorem (check --proved)",
    ExitCode.INTERNAL: "an internal error",
    ExitCode.INTERRUPTED: "interrupted (Ctrl-C; 143 and 129 by SIGTERM and SIGHUP)",
    ExitCode.BROKEN_PIPE: "the reader of standard output has gone",
}
