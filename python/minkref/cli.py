"""The command line `minkref`: the commands, and the place where errors become exit codes."""

from __future__ import annotations

import json
import os
import sys
import traceback
from collections.abc import Sequence
from typing import Annotated, NoReturn

import typer
from typer.exceptions import TyperException

from minkref.exits import ExitCode
from minkref.version import version

REPORT = "run again with --debug and report the traceback"

app = typer.Typer(
    name="minkref",
    no_args_is_help=True,
    add_completion=False,
    rich_markup_mode="rich",
    pretty_exceptions_enable=False,
    help="The exact reference and verification suite for Minkowski sums under scaling.",
    epilog="Exit codes: 0 all well; 1 something is proven wrong; 2 wrong usage or bad input; "
    "3 an implementation crashed or hung; 4 undecided (--strict); 70 an internal error.",
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
            "--version", callback=_print_version, is_eager=True, help="Print the version."
        ),
    ] = False,
    debug: Annotated[
        bool, typer.Option("--debug", help="Show the traceback of an internal error.")
    ] = False,
) -> None:
    pass


def _register() -> None:
    from minkref.commands import models, sum, targets, verify

    app.command("sum", epilog=sum.EXAMPLES)(sum.command)
    app.command("verify", epilog=verify.EXAMPLES)(verify.command)
    app.command("models", epilog=models.EXAMPLES)(models.command)
    app.command("targets", epilog=targets.EXAMPLES)(targets.command)


def run(arguments: Sequence[str]) -> int:
    """Runs one command and returns its exit code. Raises nothing but KeyboardInterrupt."""
    debug = "--debug" in arguments
    rest = [argument for argument in arguments if argument != "--debug"]
    try:
        from minkref.errors import Refusal
    except ImportError as error:
        built = "build the extension module with `make run`"
        return _internal(error, debug, built if "_core" in str(error) else REPORT)
    try:
        if not app.registered_commands:
            _register()
        result = app(rest, prog_name="minkref", standalone_mode=False)
        return int(result or 0)
    except Refusal as refusal:
        return _refuse(refusal.document(), rest)
    except TyperException as error:
        if not error.format_message():  # no command: the help has been shown
            return ExitCode.USAGE
        return _refuse(_usage(error), rest)
    except typer.Abort:
        return 130
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return ExitCode.ALL_WELL
    except Exception as error:  # noqa: BLE001 the border of the program
        return _internal(error, debug, REPORT)


def _usage(error: TyperException) -> dict[str, object]:
    context = getattr(error, "ctx", None)
    path = context.command_path if context else "minkref"
    return {
        "code": "usage",
        "what": error.format_message(),
        "where": path,
        "mend": f"`{path} --help` shows the options and examples",
    }


def _refuse(error: dict[str, object], arguments: Sequence[str]) -> int:
    if "--json" in arguments:
        command = next((a for a in arguments if not a.startswith("-")), "")
        value = {"version": version(), "command": command, "error": error}
        sys.stdout.write(json.dumps(value, ensure_ascii=False, indent=2) + "\n")
    sys.stderr.write(f"minkref: {error['where']}: {error['what']}\n")
    if error["mend"]:
        sys.stderr.write(f"  mend: {error['mend']}\n")
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
    sys.exit(run(sys.argv[1:]))
