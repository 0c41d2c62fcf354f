"""A verb of the command line: what it takes in each setting, and what answers it there."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from importlib import import_module
from typing import Any

from minkref.cli.options import Schema
from minkref.cli.request import fields_of, request_of, signed, union_of
from minkref.errors import Refusal
from minkref.settings import Setting, setting_of


@dataclass(frozen=True)
class Verb:
    """A verb in one setting. `request`: a frozen dataclass, whose fields are exactly the options
    that there are. `run`: `module:function`, which answers a request; imported when it is asked.
    For who gives an option that there is not: `why` it is missing, and what to do `instead`, both
    by option; `code`: of the refusal."""

    request: type
    run: str
    why: Mapping[str, str] = field(default_factory=dict)
    instead: Mapping[str, str] = field(default_factory=dict)
    code: str = "usage"


@dataclass(frozen=True)
class Absent:
    """A setting in which there is no such verb: what is refused, and the way out."""

    what: str
    mend: str


SCHEMA = inspect.Parameter(
    "schema", inspect.Parameter.KEYWORD_ONLY, default=False, annotation=Schema
)


def command_of(name: str, told: str, verbs: Mapping[Setting, Verb | Absent]) -> Callable[..., None]:
    """The command `minkref NAME`: its options are those of all settings, its first two arguments
    the operands, which choose one. `told`: its help."""
    fields = union_of([verb.request for verb in verbs.values() if isinstance(verb, Verb)])

    def command(**values: Any) -> None:
        given = {each.name: each.option for each in fields if each.is_given(values[each.name])}
        operands = [word for each in fields[:2] if (word := values[each.name]) is not None]
        setting = setting_of(operands, given.values(), verbs.keys())
        if setting is None:
            mend = f"`minkref {name} --help` shows the options and examples"
            raise Refusal(f"Missing argument '{fields[1].name}'.", f"minkref {name}", mend)
        verb = verbs[setting]
        if isinstance(verb, Absent):
            raise Refusal(verb.what, " and ".join(operands), verb.mend, f"not-in-{setting.name}")
        refuse_others(name, setting, verb, given)
        answer(verb, values)

    return signed(command, told, [*(each.parameter for each in fields), SCHEMA])


def command_anywhere(told: str, verb: Verb) -> Callable[..., None]:
    """A command that is the same in all settings."""
    fields = fields_of(verb.request)

    def command(**values: Any) -> None:
        answer(verb, values)

    return signed(command, told, [*(each.parameter for each in fields), SCHEMA])


def answer(verb: Verb, values: Mapping[str, Any]) -> None:
    """Makes the request of what the command line gives, and runs it."""
    module, _, run = verb.run.partition(":")
    getattr(import_module(module), run)(request_of(verb.request, values))


def refuse_others(name: str, setting: Setting, verb: Verb, given: Mapping[str, str]) -> None:
    """Refuses options that the verb does not have in the setting. `given`: by field."""
    known = {each.name for each in fields_of(verb.request)}
    others = [option for field, option in given.items() if field not in known]
    if not others:
        return
    these, them = ("this option", "it") if len(others) == 1 else ("these options", "them")
    reasons = dict.fromkeys(verb.why[option] for option in others if option in verb.why)
    ways = dict.fromkeys(verb.instead[option] for option in others if option in verb.instead)
    raise Refusal(
        "; ".join([f"`minkref {name}` does not have {these} {setting.where}", *reasons]),
        ", ".join(others),
        ", or ".join([f"leave {them} out", *ways]),
        verb.code,
    )
