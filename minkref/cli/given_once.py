"""Options of one value: a second value is refused, and none is dropped in silence."""

from __future__ import annotations

from typing import Any

from minkref.errors import Refusal


def give_once(command: Any) -> None:
    """Lets a command, and all commands of a group that are built, refuse an option given again. A
    flag may be repeated, unless it has an opposite."""
    for below in getattr(command, "commands", {}).values():
        give_once(below)
    make_parser = command.make_parser

    def make_watchful_parser(context: Any) -> Any:
        parser = make_parser(context)
        parse = parser.parse_args

        def parse_args(args: list[str]) -> Any:
            given = list(args)
            values, rest, order = parse(args=args)
            if not context.resilient_parsing:
                _refuse_second_values(order, given)
            return values, rest, order

        parser.parse_args = parse_args
        return parser

    command.make_parser = make_watchful_parser


def _refuse_second_values(order: list[Any], given: list[str]) -> None:
    """`order`: parameters as they were found; `given`: the words of the command line."""
    seen: set[str] = set()
    for parameter in order:
        is_one = parameter.param_type_name == "option" and not parameter.multiple
        if not is_one or (parameter.is_flag and not parameter.secondary_opts):
            continue
        if parameter.name in seen:
            names = [*parameter.opts, *parameter.secondary_opts]
            used = [word.partition("=")[0] for word in given]
            name = next((name for name in names if name in used), names[0])
            raise Refusal("this option is given twice, and has one value", name, "give it once")
        seen.add(parameter.name)
