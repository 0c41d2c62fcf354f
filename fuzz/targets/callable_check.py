"""Whether a `py:` target can be loaded, tried in a process of its own."""

from __future__ import annotations

import multiprocessing
from multiprocessing.connection import Connection

from minkref.errors import Refusal, message_of
from minkref.fuzz.run import child
from minkref.fuzz.targets.python_callable import load_function
from minkref.fuzz.targets.shared_library import load_library

SO_MEND = "write so:./library.so:function (fuzz/adapters/minkref_adapter.h)"
MEND = "write py:module:function, the module importable from here"


def refuse_unless_callable(name: str, seconds: float) -> None:
    """Refuses a name that gives no function. Whatever the module does on import, this process goes
    on."""
    parts = name.split(":")
    library = parts[0] == "so"
    if len(parts) != 3 or not all(parts):
        what = "C" if library else "Python"
        raise Refusal(f"this names no {what} function", name, SO_MEND if library else MEND)
    fault = _fault(name, seconds)
    if fault:
        raise Refusal(f"the function cannot be loaded: {fault}", name, SO_MEND if library else MEND)


def _fault(name: str, seconds: float) -> str:
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe()
    process = context.Process(target=_load, args=(theirs, name), daemon=False)
    process.start()
    theirs.close()
    try:
        if not ours.poll(seconds):
            return f"no end of the import in {seconds:g} s"
        return str(ours.recv())
    except (EOFError, OSError):
        process.join(1)
        return f"the import ended its process (exit code {process.exitcode})"
    finally:
        child.end(process)
        ours.close()


def _load(pipe: Connection, name: str) -> None:
    child.begin()
    try:
        load_library(name) if name.startswith("so:") else load_function(name)
        fault = ""
    except BaseException as error:  # noqa: BLE001 a module may do anything on import
        fault = message_of(error)
    pipe.send(fault)
