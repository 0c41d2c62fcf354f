"""Words of types that msgspec does not know."""

from __future__ import annotations

from collections.abc import Callable
from types import NoneType
from typing import TYPE_CHECKING, Any, TypeVar

Kind = TypeVar("Kind", bound=type)

RULES: dict[type, dict[str, Any]] = {}
EXACTLY_ONE = {"minProperties": 1, "maxProperties": 1}

if TYPE_CHECKING:
    from typing import Union as Either
else:

    class Either:
        """As `Union`, of several kinds of objects: `minkref.schemas.make` asks for the kinds."""

        kinds: tuple[type, ...]

        def __class_getitem__(cls, kinds: tuple[Any, ...]) -> type:
            several = tuple(NoneType if kind is None else kind for kind in kinds)
            return type("Either", (cls,), {"kinds": several})


def ruled(**rules: Any) -> Callable[[Kind], Kind]:
    """The schema of the objects of a type has these rules too."""

    def noted(kind: Kind) -> Kind:
        RULES[kind] = rules
        return kind

    return noted


__all__ = ["EXACTLY_ONE", "RULES", "Either", "ruled"]
