"""Unreadable mesh files: their words, numbers, members and headers."""

from __future__ import annotations

import json
import struct
from random import Random

from minkref.degeneracies.invalid.encoding import MARKS, NOT_UTF8
from minkref.degeneracies.invalid.member import Families, Invalid
from minkref.degeneracies.invalid.mesh_sheet import FORMS, MESH, MeshSheet, body, refused, sheet

FAMILIES = Families(MESH)

TEXTS = ("off", "obj", "ply")  # formats with words
NO_NUMBERS = ("nan", "NaN", "inf", "-Infinity", "0x10", "1,5", "--3", "1e", "1.2.3", "١", "x")
DIGITS, EXPONENT, DEPTH = 10_000, 10_000, 128


def drawn(dice: Random, *forms: str) -> MeshSheet:
    return sheet(dice, body(dice), forms or FORMS)


def spoilt(dice: Random, name: str, text: str, *more: str) -> Invalid:
    """With another text for a coordinate."""
    page = drawn(dice)
    vertex = dice.randrange(len(page.vertices))
    page.vertices[vertex][dice.randrange(3)] = text
    place = f"vertex {vertex}", f"line {page.line_of_vertex(vertex)}"
    return refused(page, name, name, *place, *more)


@FAMILIES.add("a coordinate that is no finite number")
def not_a_number(dice: Random) -> Invalid:
    if dice.random() < 0.15:
        return _in_binary(dice)
    return spoilt(dice, "not-a-number", dice.choice(NO_NUMBERS))


def _in_binary(dice: Random) -> Invalid:
    """NaN or infinity as a float of a binary STL."""
    page = drawn(dice)
    page.form = "stl"
    numbers = [float(dice.randint(0, 9)) for _ in range(9)]
    vertex = dice.randrange(3)
    numbers[3 * vertex + dice.randrange(3)] = dice.choice((float("nan"), float("inf")))
    content = bytes(80) + struct.pack("<I12fH", 1, 0, 0, 0, *numbers, 0)
    return refused(page, "not-a-number", "not-a-number", f"vertex {vertex}", content=content)


@FAMILIES.add("a coordinate with the denominator zero")
def zero_denominator(dice: Random) -> Invalid:
    return spoilt(dice, "zero-denominator", f"{dice.randint(-9, 9)}/{'0' * dice.randint(1, 3)}")


@FAMILIES.add("a number of more than ten thousand digits")
def number_too_long(dice: Random) -> Invalid:
    count = dice.choice((DIGITS + 1, DIGITS + 9, 100_000))
    digits = "".join(dice.choice("123456789") for _ in range(97)) * (count // 97 + 1)
    text = dice.choice(("{}", "0.{}", "{}/7", "-{}")).format(digits[:count])
    return spoilt(dice, "number-too-long", text)


@FAMILIES.add("an exponent beyond ten thousand")
def exponent_too_large(dice: Random) -> Invalid:
    exponent = dice.choice((EXPONENT + 1, 10**6, 2**31, 2**64 + 1))
    text = f"{dice.choice(('1', '0', '-2.5'))}{dice.choice('eE')}{dice.choice(('', '-'))}{exponent}"
    return spoilt(dice, "exponent-too-large", text, text[:30])


@FAMILIES.add("a mesh file with nothing in it")
def empty_file(dice: Random) -> Invalid:
    page = drawn(dice)
    return refused(page, "empty-file", "empty-file", content=dice.choice(("", "\n", " \n\t\n")))


@FAMILIES.add("a mesh file that holds a NUL byte")
def nul_byte(dice: Random) -> Invalid:
    page = drawn(dice)
    data = bytearray(page.text().encode())
    at = dice.randrange(len(data))
    data[at:at] = bytes(dice.choice((1, 1, 512)))
    return refused(page, "nul-byte", "nul-byte", content=bytes(data))


@FAMILIES.add("a mesh file in another encoding than UTF-8")
def not_utf8(dice: Random) -> Invalid:
    """UTF-16 or UTF-32 with a mark, or wrong bytes in a string of JSON."""
    page = drawn(dice)
    name = dice.choice(tuple(MARKS))
    content = MARKS[name] + page.text().encode(name)
    if page.form == "json" and dice.random() < 0.6:
        vertex = dice.randrange(len(page.vertices))
        page.vertices[vertex][dice.randrange(3)] += "@"
        content = page.text().encode().replace(b"@", dice.choice(NOT_UTF8))
    return refused(page, "not-utf8", "not-utf8", content=content)


@FAMILIES.add("a mesh file that breaks the grammar of its format")
def syntax(dice: Random) -> Invalid:
    """A vertex of too few or too many numbers, or a wrong first word."""
    page = drawn(dice, *TEXTS)
    if dice.random() < 0.3 and page.form != "obj":
        lines = page.lines()
        lines[0] = dice.choice(("FOO", "OF", "solid"))
        return refused(page, "syntax", "syntax", "line 1", content="\n".join(lines) + "\n")
    vertex = dice.randrange(len(page.vertices))
    del page.vertices[vertex][2]
    line = f"line {page.line_of_vertex(vertex)}"
    return refused(page, "syntax", "syntax", line)


@FAMILIES.add("a mesh file that ends too early")
def truncated(dice: Random) -> Invalid:
    """The text ends early; a binary file is shorter than it says."""
    if dice.random() < 0.2:
        page = drawn(dice)
        page.form = "stl"
        count = dice.randint(2, 90)
        content = bytes(80) + struct.pack("<I", count) + bytes(50 * (count - 1))
        return refused(page, "truncated", "truncated", str(84 + 50 * count), content=content)
    page = drawn(dice, "off", "ply", "json")
    lines = page.lines()
    kept = dice.randint(2, len(lines) - 2)
    return refused(page, "truncated", "truncated", "line ", content="\n".join(lines[:kept]) + "\n")


@FAMILIES.add("a mesh file with text after its end")
def trailing_text(dice: Random) -> Invalid:
    page = drawn(dice, "off", "ply", "json")
    last = len(page.lines()) + 1
    more = dice.choice(("3 0 1 2", "0 0 0", "END"))
    return refused(
        page, "trailing-text", "trailing-text", f"line {last}", content=page.text() + more + "\n"
    )


@FAMILIES.add("a mesh without its vertices or its faces")
def missing_member(dice: Random) -> Invalid:
    page = drawn(dice, "json")
    value = json.loads(page.text())
    name = dice.choice(("vertices", "faces"))
    if name == "vertices":
        content = json.dumps({"faces": value["faces"]})
    else:
        content = json.dumps({"vertices": value["vertices"]})
    return refused(page, "missing-member", "missing-member", name, "line 1", content=content)


@FAMILIES.add("a mesh with a member that is not known")
def unknown_member(dice: Random) -> Invalid:
    page = drawn(dice, "json")
    name = dice.choice(("face", "Vertices", "normals", "name", "edges"))
    content = json.dumps(json.loads(page.text()) | {name: []})
    return refused(page, "unknown-member", "unknown-member", name, content=content)


@FAMILIES.add("a mesh with a member given twice")
def duplicate_member(dice: Random) -> Invalid:
    page = drawn(dice, "json")
    name = dice.choice(("vertices", "faces"))
    text = page.text().rstrip()
    content = f'{text[:-1]}, "{name}": []}}'
    return refused(page, "duplicate-member", "duplicate-member", name, content=content)


@FAMILIES.add("a value of a mesh of another type than is due")
def wrong_type(dice: Random) -> Invalid:
    """An index as a text, a vertex or a face that is none; or a property of a header."""
    if dice.random() < 0.3:
        page = drawn(dice, "ply")
        lines = page.lines()
        at, old, new = dice.choice(
            ((7, "property list uchar int", "property int"), (3, "double", "list uchar double"))
        )
        lines[at] = lines[at].replace(old, new)
        return refused(page, "wrong-type", "wrong-type", "line ", content="\n".join(lines) + "\n")
    page = drawn(dice, "json")
    value = json.loads(page.text())
    if dice.random() < 0.5:
        face = dice.randrange(len(value["faces"]))
        value["faces"][face] = dice.choice((None, 7, "0 1 2", ["0", "1", "2"], [[0], [1], [2]]))
        place = f"face {face}"
    else:
        vertex = dice.randrange(len(value["vertices"]))
        value["vertices"][vertex] = dice.choice((None, 7, "0 0 0", ["0", "0"], ["0"] * 4))
        place = f"vertex {vertex}"
    return refused(page, "wrong-type", "wrong-type", place, content=json.dumps(value))


@FAMILIES.add("a mesh of values nested deeper than 128")
def too_deep(dice: Random) -> Invalid:
    page = drawn(dice, "json")
    depth = dice.choice((DEPTH + 1, 1000, 100_000))
    value = "[" * depth + "]" * depth
    content = f'{{"vertices": [], "faces": {value}}}'
    return refused(page, "too-deep", "too-deep", "line 1", content=content)


def _header(dice: Random, name: str, line: int, text: str, *place: str) -> Invalid:
    """A PLY with one changed header line."""
    page = drawn(dice, "ply")
    lines = page.lines()
    lines[line - 1] = text
    return refused(page, name, name, *place, content="\n".join(lines) + "\n")


@FAMILIES.add("a mesh in an encoding unknown")
def unsupported_encoding(dice: Random) -> Invalid:
    if dice.random() < 0.4:
        page = drawn(dice, "off")
        content = page.text().replace("OFF", "OFF BINARY", 1)
        name = "unsupported-encoding"
        return refused(page, name, name, "line 1", content=content)
    word = dice.choice(("binary", "utf8", "ASCII", "gzip"))
    return _header(dice, "unsupported-encoding", 2, f"format {word} 1.0", "line 2", word)


@FAMILIES.add("a PLY file of another version")
def unsupported_version(dice: Random) -> Invalid:
    number = dice.choice(("1.1", "2.0", "1", "0.9"))
    return _header(dice, "unsupported-version", 2, f"format ascii {number}", "line 2", number)


@FAMILIES.add("a mesh with lines, points or curves")
def unsupported_geometry(dice: Random) -> Invalid:
    """Elements that a polyhedron does not have."""
    if dice.random() < 0.3:
        page = drawn(dice, "off")
        content = page.text().replace("OFF", dice.choice(("4OFF", "nOFF")), 1)
        name = "unsupported-geometry"
        return refused(page, name, name, "line 1", content=content)
    page = drawn(dice, "obj")
    word = dice.choice(("l 1 2", "p 1", "curv 0 1 1 2", "surf 0 1 0 1 1 2 3 4"))
    lines = page.lines()
    at = dice.randint(len(page.vertices) + 1, len(lines))
    lines.insert(at, word)
    return refused(
        page, "unsupported-geometry", "unsupported-geometry", f"line {at + 1}", word.split()[0],
        content="\n".join(lines) + "\n",
    )  # fmt: skip


@FAMILIES.add("a line of an OBJ file that begins with no word of it")
def unknown_word(dice: Random) -> Invalid:
    """A misspelt face in an OBJ file leaves a hole."""
    page = drawn(dice, "obj")
    lines = page.lines()
    at = dice.randrange(1, len(lines))
    word = dice.choice(("F", "face", "q", "V", "vertex", "faces"))
    lines[at] = f"{word} {lines[at].split(' ', 1)[1]}"
    return refused(
        page, "unknown-word", "unknown-word", f"line {at + 1}", word,
        content="\n".join(lines) + "\n",
    )  # fmt: skip


@FAMILIES.add("a PLY header that lacks a coordinate")
def missing_property(dice: Random) -> Invalid:
    line, name = dice.choice(((4, "x"), (5, "y"), (6, "z")))
    return _header(dice, "missing-property", line, "property double w", "line 3", f'"{name}"')


@FAMILIES.add("a PLY header with a property twice")
def duplicate_property(dice: Random) -> Invalid:
    line, name = dice.choice(((5, "x"), (6, "y"), (6, "x")))
    text = f"property double {name}"
    return _header(dice, "duplicate-property", line, text, "line 3", f'"{name}"')


@FAMILIES.add("a PLY header with an element twice")
def duplicate_element(dice: Random) -> Invalid:
    text = f"element vertex {dice.randint(0, 9)}"
    return _header(dice, "duplicate-element", 7, text, "line 7", "vertex")
