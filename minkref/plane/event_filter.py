"""The language of `minkref events --where`: a condition that selects events.

kind = triple and s > 7/5 and change = swap
1 <= s < 2 and x in [0, 5/2] and y in (-1, 1)
parents has S 0.12 at 1.3 and not parents has T
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NoReturn

from lark import Lark, Token, Transformer, v_args
from lark.exceptions import UnexpectedCharacters, UnexpectedInput, UnexpectedToken, VisitError
from minkref import _core
from minkref.errors import Refusal, nearest
from minkref.exact import read_number

LONGEST = 4000  # characters
GRAMMAR = r"""
start: any
any: all ("or" all)*
all: factor ("and" factor)*
?factor: "not" factor                                 -> negation
       | "(" any ")"
       | NAME COMPARISON (NAME | NUMBER)              -> comparison
       | NUMBER COMPARISON NAME [COMPARISON NUMBER]   -> chain
       | NAME "in" "[" NUMBER "," NUMBER close        -> closed_below
       | NAME "in" "(" NUMBER "," NUMBER close        -> open_below
       | NAME "in" "(" NAME ("," NAME)* ")"           -> words
       | NAME "has" NUMBER                            -> feature
       | NAME "has" EDGE [PLACE] ["at" PLACE]         -> parent
!close: "]" | ")"
COMPARISON: "<=" | ">=" | "!=" | "==" | "=" | "<" | ">"
EDGE.2: "S" | "T"
PLACE.2: /[0-9]+\.[0-9]+/
NUMBER: /[+-]?([0-9]+\/[0-9]+|([0-9]+(\.[0-9]*)?|\.[0-9]+)([eE][+-]?[0-9]+)?)/
NAME: /[A-Za-z_][A-Za-z_0-9]*/
%ignore /[ \t\r\n]+/
"""
_CHANGES = {
    "pair": ("birth", "death", "touch"),
    "parallel": ("birth", "death", "touch", "overlap"),
    "triple": ("swap",),
    "arrangement": ("birth", "death", "touch", "overlap", "swap"),
    "boundary": ("birth", "death", "swap", "touch"),
    "topology": ("birth", "death", "merge", "split", "touch"),
}
_NUMBERS = ("s", "x", "y", "rank")
_OF_TOPOLOGY = ("feature", "before", "after", "parts")
_EXAMPLE = "write, for example, 'change = birth and 1 < s <= 7/5'"
_MIRRORED = {"<": ">", "<=": ">=", ">": "<", ">=": "<="}
_SAID = {  # grammar tokens, for people
    "NAME": "a field or word", "NUMBER": "a number", "COMPARISON": "a sign (= != < <= > >=)",
    "LPAR": "'('", "RPAR": "')'", "LSQB": "'['", "RSQB": "']'", "COMMA": "a comma",
    "EDGE": "S or T", "PLACE": "RING.INDEX, as 0.12", "$END": "the end",
}  # fmt: skip
_INSTEAD = {
    "/": "the fraction without spaces: 7/5", ",": "a decimal with a point, a fraction, or `in`",
    "&": "and", "|": "or", "!": "not", "~": "not", "'": "words without quotes",
    '"': "words without quotes", "≤": "<=", "≥": ">=", "≠": "!=",
}  # fmt: skip


def read_filter(text: str, kind: str) -> _core.EventCondition:
    """Read a condition on events of one kind. Refuses text that is no condition, fields and words
    that these events never have, and malformed numbers, naming the place in the text. Reads numbers
    exactly."""
    if len(text) > LONGEST:
        what = f"the condition has more than {LONGEST} characters"
        raise Refusal(what, "--where", "use several runs, or a file and jq", "limit")
    try:
        parser = Lark(GRAMMAR, parser="lalr", transformer=_Conditions(text, kind))
        condition = parser.parse(text)
    except VisitError as error:
        raise error.orig_exc from None
    except UnexpectedInput as error:
        _refuse_syntax(text, error)
    assert isinstance(condition, _core.EventCondition)
    return condition


def _refuse_syntax(text: str, error: UnexpectedInput) -> NoReturn:
    expected: Iterable[str] = ()
    position = len(text)
    if isinstance(error, UnexpectedCharacters):
        position, expected = error.pos_in_stream or 0, error.allowed or ()
    elif isinstance(error, UnexpectedToken):
        expected = error.accepts or error.expected
        if error.token.type != "$END":
            position = error.token.start_pos or 0
    words = sorted({_SAID.get(name, f"'{name.lower()}'") for name in expected})
    mend = f"continue with {', '.join(words)}" if words else _EXAMPLE
    letter = text[position : position + 1]
    if letter in _INSTEAD:
        mend = f"write {_INSTEAD[letter]}"
    elif not text.strip():
        mend = _EXAMPLE
    what = (
        "the condition ends too early"
        if position >= len(text.rstrip())
        else "this is not understood"
    )
    raise Refusal(what, _place(text, position), mend, "bad-condition")


def _place(text: str, position: int) -> str:
    rest = text[position : position + 30]
    more = "..." if len(text) > position + 30 else ""
    at = f': "{rest}{more}"' if rest.strip() else ", the end"
    return f"--where, character {position + 1}{at}"


@v_args(inline=True)
class _Conditions(Transformer[Token, Any]):
    """Turns parsed text into conditions."""

    def __init__(self, text: str, kind: str) -> None:
        super().__init__()
        self._text = text
        self._kind = kind
        self._kinds = ("pair", "parallel", "triple") if kind == "arrangement" else (kind,)

    def start(self, condition: _core.EventCondition) -> _core.EventCondition:
        return condition

    def any(self, *conditions: _core.EventCondition) -> _core.EventCondition:
        return conditions[0] if len(conditions) == 1 else _core.EventCondition.any([*conditions])

    def all(self, *conditions: _core.EventCondition) -> _core.EventCondition:
        return conditions[0] if len(conditions) == 1 else _core.EventCondition.all([*conditions])

    def negation(self, condition: _core.EventCondition) -> _core.EventCondition:
        return _core.EventCondition.none([condition])

    def comparison(self, name: Token, sign: Token, value: Token) -> _core.EventCondition:
        if value.type == "NUMBER":
            return self._compared(name, sign, value)
        self._check(name, self._words(), value)
        if sign not in ("=", "==", "!="):
            self._refuse(sign, "words have no order", f"write {name} = {value}, or !=")
        self._check_word(name, value)
        condition = _core.EventCondition.word(name, [value])
        return self.negation(condition) if sign == "!=" else condition

    def chain(
        self, first: Token, sign: Token, name: Token, second: Token | None, last: Token | None
    ) -> _core.EventCondition:
        mirrored = Token.new_borrow_pos(sign.type, _MIRRORED.get(sign, sign), sign)
        condition = self._compared(name, mirrored, first)
        if second is None or last is None:
            return condition
        if {sign[0], second[0]} not in ({"<"}, {">"}):
            self._refuse(second, "this is not an interval", "write A < s < B, or <=")
        return self.all(condition, self._compared(name, second, last))

    def close(self, bracket: Token) -> Token:
        return bracket

    def closed_below(
        self, name: Token, low: Token, high: Token, close: Token
    ) -> _core.EventCondition:
        return self._interval(name, low, high, True, close == "]")

    def open_below(
        self, name: Token, low: Token, high: Token, close: Token
    ) -> _core.EventCondition:
        return self._interval(name, low, high, False, close == "]")

    def words(self, name: Token, *values: Token) -> _core.EventCondition:
        self._check(name, self._words(), values[0])
        for value in values:
            self._check_word(name, value)
        return _core.EventCondition.word(name, [str(value) for value in values])

    def feature(self, name: Token, number: Token) -> _core.EventCondition:
        self._check(name, ("before", "after"), number)
        if not number.isdigit() or len(number) > 9:
            self._refuse(number, "features are numbered from 0", f"write {name} has 0: the outside")
        return _core.EventCondition.feature(name, int(number))

    def parent(
        self, name: Token, kind: Token, edge: Token | None, vertex: Token | None
    ) -> _core.EventCondition:
        self._check(name, ("parents",), kind)
        return _core.EventCondition.parent(kind, self._ids(edge), self._ids(vertex))

    def _ids(self, place: Token | None) -> tuple[int, int] | None:
        if place is None:
            return None
        if len(place) > 18:
            self._refuse(place, "no ring and index are that large", "name an edge as 0.12")
        ring, index = (int(number) for number in place.split("."))
        return ring, index

    def _compared(self, name: Token, sign: Token, value: Token) -> _core.EventCondition:
        number = self._number(name, value)
        low = number if sign[0] in "=!>" else None
        high = number if sign[0] in "=!<" else None
        closed = sign not in ("<", ">")
        condition = _core.EventCondition.number(name, low, high, closed, closed)
        return self.negation(condition) if sign == "!=" else condition

    def _interval(
        self, name: Token, low: Token, high: Token, with_low: bool, with_high: bool
    ) -> _core.EventCondition:
        first, last = self._number(name, low), self._number(name, high)
        return _core.EventCondition.number(name, first, last, with_low, with_high)

    def _number(self, name: Token, value: Token) -> str:
        self._check(name, self._numbers(), value)
        where = _place(self._text, value.start_pos or 0)
        mend = "give a number, for example 7/5, -0.25 or 3"
        return str(read_number(value, "number", where, mend))

    def _numbers(self) -> tuple[str, ...]:
        return (*_NUMBERS, "parts") if self._kind == "topology" else _NUMBERS

    def _words(self) -> tuple[str, ...]:
        return ("kind", "change", "feature") if self._kind == "topology" else ("kind", "change")

    def _check(self, name: Token, fitting: tuple[str, ...], value: Token) -> None:
        """Refuse a field that these events do not have, or that needs another question."""
        topology = self._kind == "topology"
        if name in fitting and (topology or name not in _OF_TOPOLOGY):
            return
        lists = ("parents", "before", "after") if topology else ("parents",)
        known = (*self._numbers(), *self._words(), *lists)
        if name in _OF_TOPOLOGY and not topology:
            what = f"{self._kind} events have no {name}"
            self._refuse(name, what, f"choose --kind topology, or ask for {', '.join(known)}")
        if name not in known:
            mend = f"{nearest(name, known)}ask for {', '.join(known)}"
            self._refuse(name, f"there is no field '{name}'", mend)
        if name == "parents":
            how = "parents has S 0.12 at 1.3, or parents has T"
        elif name in lists:
            how = f"{name} has 0"
        elif name in self._words():
            how = f"{name} = {self._of(name)[0]}"
        else:
            how = f"{name} > 7/5, or {name} in [1, 2]"
        self._refuse(name, f"this is not a condition on {name}", f"write {how}")

    def _of(self, name: str) -> tuple[str, ...]:
        """List a field's possible words."""
        if name == "kind":
            return self._kinds
        return _CHANGES[self._kind] if name == "change" else ("hole", "component")

    def _check_word(self, name: Token, value: Token) -> None:
        known = self._of(name)
        if value in known:
            return
        what = f"the {name} of {self._kind} events is never '{value}'"
        mend = f"{nearest(value, known)}it is {' or '.join(known)}"
        if name == "kind" and value in _CHANGES:
            other = "" if value in ("boundary", "topology", "arrangement") else " or arrangement"
            mend = f"{mend}; for {value} events choose --kind {value}{other}"
        self._refuse(value, what, mend)

    def _refuse(self, token: Token, what: str, mend: str) -> NoReturn:
        raise Refusal(what, _place(self._text, token.start_pos or 0), mend, "bad-condition")
