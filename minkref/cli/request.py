"""Requests: frozen dataclasses whose fields are the options of a command, each written once; and
the signature of them that typer reads."""

from __future__ import annotations

import dataclasses
import inspect
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Annotated, Any, get_args, get_type_hints

from typer.models import ArgumentInfo, OptionInfo

_annotated: Any = Annotated


@dataclass(frozen=True)
class Read:
    """In the annotation of a field: its value is made of what the command line gives, a `kind`, and
    of the name of the option."""

    value: Callable[[Any, str], Any]
    kind: type = str


@dataclass(frozen=True)
class Field:
    """A field of a request. `option`: `--name`, which is empty for an argument."""

    name: str
    option: str
    parameter: inspect.Parameter
    read: Callable[[Any, str], Any] | None

    @property
    def is_required(self) -> bool:
        return self.parameter.default is inspect.Parameter.empty

    def value(self, given: Any) -> Any:
        """The field of what the command line gives."""
        return given if given is None or self.read is None else self.read(given, self.option)

    def is_given(self, value: Any) -> bool:
        """The option says something else than its default."""
        return bool(self.option) and value not in (self.parameter.default, [], ())


def fields_of(request: type) -> list[Field]:
    """All fields, in their order. Each has an option or an argument of typer in its annotation."""
    hints = get_type_hints(request, include_extras=True)
    return [_field(field, *get_args(hints[field.name])) for field in dataclasses.fields(request)]


def _field(field: dataclasses.Field[Any], kind: Any, *metadata: Any) -> Field:
    info = next(m for m in metadata if isinstance(m, OptionInfo | ArgumentInfo))
    read = next((m for m in metadata if isinstance(m, Read)), None)
    is_required = field.default is dataclasses.MISSING
    default: Any = inspect.Parameter.empty if is_required else field.default
    if read is not None:
        kind = read.kind if default is not None else read.kind | None
        default = str(default) if default not in (None, inspect.Parameter.empty) else default
    parameter = inspect.Parameter(
        field.name,
        inspect.Parameter.KEYWORD_ONLY,
        default=default,
        annotation=_annotated[kind, info],
    )
    option = str(info.default).partition("/")[0] if isinstance(info, OptionInfo) else ""
    return Field(field.name, option, parameter, read.value if read is not None else None)


def union_of(requests: Sequence[type]) -> list[Field]:
    """Merge the fields of all requests; the first request with a field defines it. A required field
    becomes optional if some request lacks it. Each request keeps its order; among free choices,
    fields of earlier requests come first."""
    lists = [fields_of(request) for request in requests]
    first: dict[str, Field] = {}
    for field in (field for fields in lists for field in fields):
        first.setdefault(field.name, field)
    shared = set[str].intersection(*({field.name for field in each} for each in lists))
    order = merged([[field.name for field in each] for each in lists])
    return [first[name] if name in shared else _optional(first[name]) for name in order]


def _optional(field: Field) -> Field:
    """Give a required field the default None."""
    if not field.is_required:
        return field
    kind, *metadata = get_args(field.parameter.annotation)
    annotation = _annotated[kind | None, *metadata]
    return replace(field, parameter=field.parameter.replace(default=None, annotation=annotation))


def merged(lists: list[list[str]]) -> list[str]:
    """One list of all names, in which no list finds its order changed."""
    order: list[str] = []
    rest = [each for each in lists if each]
    while rest:
        heads = (each[0] for each in rest)
        head = next(name for name in heads if not any(name in each[1:] for each in rest))
        order.append(head)
        rest = [left for each in rest if (left := [name for name in each if name != head])]
    return order


def request_of(request: type, given: Mapping[str, Any]) -> Any:
    """The request of what the command line gives, which may be more."""
    return request(**{each.name: each.value(given[each.name]) for each in fields_of(request)})


def signed(
    command: Callable[..., None], told: str, parameters: Sequence[inspect.Parameter]
) -> Callable[..., None]:
    """The command with the help and the signature that typer shows."""
    command.__doc__ = told
    command.__annotations__ = {each.name: each.annotation for each in parameters}
    command.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
    return command
