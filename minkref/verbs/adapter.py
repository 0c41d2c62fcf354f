"""`minkref adapter`: programs that let an implementation be tested."""

from __future__ import annotations

import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Annotated

import typer
from minkref.errors import Refusal
from minkref.fuzz.adapters.template import HEADER, LANGUAGES, template
from minkref.fuzz.libraries import catalogue
from minkref.output.terminal import escaped
from minkref.verbs import adapter_check

NEW_EXAMPLES = """Examples:

minkref adapter new my_library --language python

minkref adapter new my_library --language c++ && minkref verify ./my_library_adapter --seconds 60"""

INSTALL_EXAMPLES = """Examples:

minkref adapter install clipper2 manifold3d

minkref adapter install all"""

AT_A_TIME = 3  # installations: they wait for a network most of the time

app = typer.Typer(
    no_args_is_help=True,
    add_completion=False,
    rich_markup_mode="rich",
    help="Write, check and install adapters: programs that connect an implementation to the tests.",
)


@app.command("new", epilog=NEW_EXAMPLES)
def new(
    name: Annotated[
        str, typer.Argument(help="Name of the implementation: letters, digits, - and _.")
    ],
    language: Annotated[str, typer.Option("--language", help=f"One of {', '.join(LANGUAGES)}.")],
    output: Annotated[
        Path, typer.Option("-o", "--output", help="Folder to write to.", metavar="DIR")
    ] = Path(),
) -> None:
    """Write a working adapter, for the sum of two convex polygons. Replace its sum by a call to
    your own implementation."""
    path, text, run = template(name, language, output)
    if path.exists():
        raise Refusal("this file already exists", str(path), "choose another name")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with path.open("x", encoding="utf-8") as file:
            file.write(text)
        if language == "python":
            path.chmod(0o755)
    except OSError as error:
        what = f"the file cannot be written: {error.strerror}"
        raise Refusal(what, str(path), "choose another place", "cannot-write") from error
    sys.stdout.write(escaped(f"{path}") + "\n" + "".join(f"  {line}\n" for line in run))


app.command("check", epilog=adapter_check.EXAMPLES)(adapter_check.command)


@app.command("header")
def header() -> None:
    """Print where minkref_adapter.h is, for a sum as a C function: `so:./library.so:function`.

    cc -shared -fPIC -include "$(minkref adapter header)" mine.c -o libmine.so"""
    sys.stdout.write(f"{HEADER}\n")


@app.command("install", epilog=INSTALL_EXAMPLES)
def install(
    names: Annotated[
        list[str],
        typer.Argument(help="Names of adapters in `minkref targets`, or all.", metavar="NAME..."),
    ],
) -> None:
    """Install the libraries that these adapters need, each into a folder of its own (in
    MINKREF_ADAPTERS, build/adapters, or ~/.cache/minkref/adapters). `all` leaves out adapters in
    Java and Rust, those in JavaScript without npm, and packages that would have to be built."""
    wanted = names
    if names == ["all"]:
        wanted = [name for name in catalogue.ADAPTERS if catalogue.in_everything(name)]
        left_out = [name for name in catalogue.ADAPTERS if name not in wanted]
        if left_out:
            sys.stderr.write(f"left out, to be installed by name: {', '.join(left_out)}\n")
    for name in wanted:
        catalogue.adapter_named(name)
    failed: list[Refusal] = []
    with ThreadPoolExecutor(AT_A_TIME) as pool:
        for name, refusal in zip(wanted, pool.map(_installed, wanted), strict=True):
            if refusal is None:
                sys.stdout.write(f"{name}: ready\n")
                continue
            if len(wanted) == 1:
                raise refusal
            failed.append(refusal)
            sys.stderr.write(escaped(f"{name}: {refusal}") + "\n")
    if failed:
        raise failed[0]


def _installed(name: str) -> Refusal | None:
    try:
        catalogue.install(name)
    except Refusal as refusal:
        return refusal
    return None
