"""Files with bytes other than UTF-8 text."""

from __future__ import annotations

import json
from random import Random

from minkref.degeneracies.invalid.json_text import MARK
from minkref.degeneracies.invalid.member import Families, Invalid
from minkref.degeneracies.invalid.operands import region
from minkref.degeneracies.invalid.sheet import CLOSED, Sheet, sheet
from minkref.degeneracies.invalid.writing import of_bytes, refused, text_of

FAMILIES = Families()

BLANK = (b"", b"", b"\n", b" \t\r\n", b"\n" * 50, b"\xef\xbb\xbf", b"\xef\xbb\xbf \n", b"\f\v")
# Not UTF-8: Latin-1, a lone continuation, cut short, overlong, half a surrogate pair, too large.
NOT_UTF8 = (
    b"\xe4",
    b"\x80",
    b"\xe2\x82",
    b"\xc0\xaf",
    b"\xed\xa0\x80",
    b"\xf5\x80\x80\x80",
    b"\xff",
)
MARKS = {"utf-16-le": b"\xff\xfe", "utf-16-be": b"\xfe\xff", "utf-32-be": b"\0\0\xfe\xff"}


@FAMILIES.add("a file with nothing in it, or with white space only")
def empty_file(dice: Random) -> Invalid:
    page = sheet(dice, region(dice))
    return of_bytes(page, "empty-file", dice.choice(BLANK))


@FAMILIES.add("a file that holds a NUL byte")
def nul_byte(dice: Random) -> Invalid:
    """At one place, as padding at the end, or as every other byte of UTF-16 without a mark."""
    page = sheet(dice, region(dice))
    text = text_of(dice, page)
    how = dice.choice(("one", "one", "end", "wide"))
    if how == "wide":
        return of_bytes(page, "nul-byte", text.encode("utf-16-le"), "line 1")
    at = len(text) if how == "end" else dice.randint(0, len(text))
    nuls = "\0" * (dice.choice((1, 512)) if how == "end" else 1)
    return refused(dice, page, "nul-byte", text=text[:at] + MARK + nuls + text[at:])


@FAMILIES.add("a file in another encoding than UTF-8")
def not_utf8(dice: Random) -> Invalid:
    """UTF-16 or UTF-32 with a mark, or wrong bytes in a string of JSON."""
    page = sheet(dice, region(dice))
    if page.form in ("wkt", "poly") or dice.random() < 0.4:
        name = dice.choice(tuple(MARKS))
        return of_bytes(page, "not-utf8", MARKS[name] + text_of(dice, page).encode(name))
    _spoil(dice, page)
    text = text_of(dice, page)
    if page.form in CLOSED:
        text = text.replace('"type"', f'"name": {MARK}"@", "type"', 1)
    line = text[: text.index(MARK)].count("\n") + 1
    content = text.replace(MARK, "").encode().replace(b"@", dice.choice(NOT_UTF8))
    return of_bytes(page, "not-utf8", content, f"line {line}")


def _spoil(dice: Random, page: Sheet) -> None:
    if page.form in CLOSED:
        return
    rings = [ring for part in page.polygons for ring in part]
    corner = dice.choice(dice.choice(rings))
    corner[0] = MARK + json.dumps(f"{dice.randint(0, 99)}@")
