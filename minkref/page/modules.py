"""Modules of a page as one script: each a function that is called once, after those it imports."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Callable

IMPORT = re.compile(r'^import \{([^}]*)\} from "(\.[^"]*)";$', re.M)
EXPORT = re.compile(r"^export (?=(?:const|class|(?:async )?function) (\w+))", re.M)
LEFT = re.compile(r"^(?:import|export)\b.*|</script", re.M)


class Script:
    """The script of a page. `read` gives the text of the module at a path.

    Modules name what they import, and export one constant, function or class at a time; anything
    else is refused, and so are a circle and a name that the other module does not export.
    """

    def __init__(self, read: Callable[[str], str]) -> None:
        self._read = read
        self._exports: dict[str, list[str]] = {}
        self._open: list[str] = []
        self._parts: list[str] = []

    def text(self, path: str) -> str:
        """The module at a path, behind all that it imports."""
        self._add(path)
        return "\n".join(self._parts)

    def _add(self, path: str) -> None:
        if path in self._open:
            raise ValueError(f"{path}: imports itself by {' and '.join(self._open)}")
        if path in self._exports:
            return
        self._open.append(path)
        text = IMPORT.sub(lambda found: self._taken(path, found[1], found[2]), self._read(path))
        self._open.pop()
        exports = EXPORT.findall(text)
        text = EXPORT.sub("", text)
        if left := LEFT.search(text):
            raise ValueError(f"{path}: {left[0]}: cannot stand in a page")
        self._exports[path] = exports
        given = f"return {{ {', '.join(exports)} }};\n" if exports else ""
        self._parts.append(f"const {_name(path)} = (() => {{\n{text}{given}}})();")

    def _taken(self, path: str, names: str, target: str) -> str:
        """What stands in place of an import."""
        source = posixpath.normpath(posixpath.join(posixpath.dirname(path), target))
        self._add(source)
        wanted = [name for part in names.split(",") if (name := part.strip())]
        for name in wanted:
            if name not in self._exports[source]:
                raise ValueError(f"{path}: {source} exports no {name}")
        return f"const {{ {', '.join(wanted)} }} = {_name(source)};"


def _name(path: str) -> str:
    """The constant that holds what a module exports: no name of a module begins so."""
    return "$" + re.sub(r"\W", "_", path.removesuffix(".js"))
