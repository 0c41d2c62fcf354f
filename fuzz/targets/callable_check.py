"""Whether a function can be loaded as a target, and what it declares, in a process of its own."""

from __future__ import annotations

import multiprocessing
from multiprocessing.connection import Connection

from minkref.errors import Refusal, message_of
from minkref.fuzz.run import child
from minkref.fuzz.targets.declaration import Declaration, DeclarationError
from minkref.fuzz.targets.python_callable import load_function
from minkref.fuzz.targets.shared_library import load_library

SO_MEND = "write so:./library.so:function; `minkref adapter header` prints where its header is"
MEND = "write py:module:function, the module importable from here"


def declaration_of_function(name: str, seconds: float) -> Declaration:
    """What the function of this name says of itself. Refuses a name that gives no function, and a
    declaration that is none. Whatever the module does on import, this process goes on."""
    parts = name.split(":")
    library = parts[0] == "so"
    mend = SO_MEND if library else MEND
    if len(parts) != 3 or not all(parts):
        what = "C" if library else "Python"
        raise Refusal(f"this names no {what} function", name, mend)
    found = _loaded(name, seconds)
    if isinstance(found, str):
        raise Refusal(f"the function cannot be loaded: {found}", name, mend)
    return found


def _loaded(name: str, seconds: float) -> Declaration | str:
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe()
    process = context.Process(target=_load, args=(theirs, name), daemon=False)
    process.start()
    theirs.close()
    try:
        if not ours.poll(seconds):
            return f"no end of the import in {seconds:g} s"
        found: Declaration | str = ours.recv()
        return found
    except (EOFError, OSError):
        process.join(1)
        return f"the import ended its process (exit code {process.exitcode})"
    finally:
        child.end(process)
        ours.close()


def _load(pipe: Connection, name: str) -> None:
    child.begin()
    found: Declaration | str
    try:
        found = load_library(name)[1] if name.startswith("so:") else load_function(name)[1]
    except DeclarationError as error:
        found = f"its declaration: {error}"
    except BaseException as error:  # noqa: BLE001 a module may do anything on import
        found = message_of(error)
    pipe.send(found)
