"""The command line `minkref`: the commands, and the place where errors become exit codes."""

from __future__ import annotations

import errno
import os
import sys
import traceback
from collections.abc import Callable, Sequence
from functools import cache
from typing import Annotated, Any, NoReturn

import typer
from minkref.cli.command_group import CommandGroup
from minkref.output import streams
from minkref.output.exits import MEANINGS, ExitCode
from minkref.output.signals import Ended
from minkref.version import version
from typer.exceptions import TyperException

REPORT = "run again with --debug and report the traceback"

app = typer.Typer(
    name="minkref",
    cls=CommandGroup,
    no_args_is_help=True,
    rich_markup_mode="rich",
    context_settings={"help_option_names": ["-h", "--help"]},
    pretty_exceptions_enable=False,
    help="The exact reference and verification suite for Minkowski sums under scaling.",
    epilog="Examples:\n\nminkref sum disc1 cells1815 --scale 7/5 -o sum.svg\n\n"
    "minkref verify cgal-reduced --pairs 1000 --report build/report\n\n"
    "minkref models\n\n"
    f"Exit codes: {'; '.join(f'{code:d} {what}' for code, what in MEANINGS.items())}.",
)


def _print_version(wanted: bool) -> None:
    if wanted:
        sys.stdout.write(f"minkref {version()}\n")
        raise typer.Exit


@app.callback()
def _root(
    version_wanted: Annotated[
        bool,
        typer.Option(
            "--version", "-V", callback=_print_version, is_eager=True, help="Print the version."
        ),
    ] = False,
    debug: Annotated[
        bool, typer.Option("--debug", help="Show the traceback of an internal error.")
    ] = False,
) -> None:
    pass


@cache
def _built() -> Callable[..., Any]:
    """The whole command; those below it are built when they are called."""
    return typer.main.get_command(app)


def run(arguments: Sequence[str]) -> int:
    """Runs one command and returns its exit code. Raises nothing but KeyboardInterrupt, and
    OutputLost where standard output takes nothing more."""
    debug = "--debug" in arguments
    rest = [argument for argument in arguments if argument != "--debug"]
    try:
        from minkref import _core
        from minkref.errors import Refusal, refusal_of
    except ImportError as error:
        built = "build the extension module with `make run`"
        return _internal(error, debug, built if "_core" in str(error) else REPORT)
    sys.set_int_max_str_digits(0)  # exact numbers have as many digits as they need
    try:
        result = _built()(rest, prog_name="minkref", standalone_mode=False)
        return int(result or 0)
    except streams.OutputLost:
        raise
    except Refusal as refusal:
        return _refuse(refusal.document(), rest)
    except TyperException as error:
        if not error.format_message():  # no command: the help has been shown
            return ExitCode.USAGE
        return _refuse(_usage(error, rest), rest)
    except _core.LimitExceeded as error:
        return _refuse(refusal_of(error, _path_of(rest)).document(), rest)
    except MemoryError:
        return _refuse(_no_memory(rest), rest)
    except typer.Abort:
        return ExitCode.INTERRUPTED
    except Ended as ended:
        return 128 + ended.number
    except Exception as error:  # noqa: BLE001 the border of the program
        if isinstance(error, OSError) and error.errno == errno.ENAMETOOLONG:
            return _refuse(_long_name(error, rest), rest)
        if isinstance(error, FileNotFoundError) and _folder_is_gone():
            return _refuse(_no_folder(rest), rest)
        return _internal(error, debug, REPORT)


def _usage(error: TyperException, arguments: Sequence[str]) -> dict[str, object]:
    context = getattr(error, "ctx", None)
    path = context.command_path if context else _path_of(arguments)
    mend = f"`{path} --help` shows the options and examples"
    return _error("usage", error.format_message(), path, mend)


def _no_memory(arguments: Sequence[str]) -> dict[str, object]:
    mend = "take simpler or fewer operands, or end what else the machine runs"
    return _error("memory-limit", "there is no more memory", _path_of(arguments), mend)


def _long_name(error: OSError, arguments: Sequence[str]) -> dict[str, object]:
    name = str(error.filename or "")
    what = f"no file has a name of {len(name):,} characters"
    where = f"{_path_of(arguments)}, {name[:60]}..."
    return _error("cannot-read", what, where, "check the path")


def _error(code: str, what: str, where: str, mend: str) -> dict[str, object]:
    return {"code": code, "what": what, "where": where, "mend": mend}


def _folder_is_gone() -> bool:
    try:
        os.getcwd()
    except FileNotFoundError:
        return True
    return False


def _no_folder(arguments: Sequence[str]) -> dict[str, object]:
    what = "the current folder has been removed"
    return _error("no-folder", what, _path_of(arguments), "change to one that is there: cd")


def _path_of(arguments: Sequence[str]) -> str:
    """`minkref sum` of arguments that begin with a command, also one of a group."""
    path, command = "minkref", _built()
    for word in arguments:
        known = getattr(command, "commands", {})
        if word not in known:
            break
        path, command = f"{path} {word}", known[word]
    return path


def _refuse(error: dict[str, object], arguments: Sequence[str]) -> int:
    from minkref.errors import refusal_text
    from minkref.output.documents import as_text

    sys.stderr.write(refusal_text(error))
    if "--json" in arguments:
        command = next((a for a in arguments if not a.startswith("-")), "")
        sys.stdout.write(as_text({"version": version(), "command": command, "error": error}))
    return ExitCode.USAGE


def _internal(error: Exception, debug: bool, mend: str) -> int:
    if debug:
        traceback.print_exception(error, file=sys.stderr)
    else:
        sys.stderr.write(f"minkref: internal error: {type(error).__name__}: {error}\n")
        sys.stderr.write(f"  {mend}\n")
    return ExitCode.INTERNAL


def main() -> NoReturn:
    """The entry point of the command `minkref`."""
    streams.guard()
    try:
        code = run(sys.argv[1:])
        sys.stdout.flush()
    except streams.OutputLost as lost:
        streams.give_up_output()
        code = _lost(lost)
    except KeyboardInterrupt:
        code = ExitCode.INTERRUPTED
    sys.exit(code)


def _lost(lost: streams.OutputLost) -> int:
    """The exit code where the result could not be written out."""
    if lost.reader_has_gone:
        return ExitCode.BROKEN_PIPE
    sys.stderr.write(f"minkref: cannot write to standard output: {lost}\n")
    sys.stderr.write("  fix: give it an open file with room, or use -o, --junit or --report\n")
    return ExitCode.USAGE
