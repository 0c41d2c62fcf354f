"""The C++ interface: a page for each public header, from what doxygen reads of its comments."""

from __future__ import annotations

import subprocess
import tempfile
import xml.etree.ElementTree as ElementTree
from collections import defaultdict
from dataclasses import dataclass, field
from html import escape
from pathlib import Path

Element = ElementTree.Element
FOLDER = Path("api/cpp")
KINDS = {"enum": "enum class", "typedef": "using", "class": "class", "struct": "struct"}


@dataclass
class Header:
    path: str  # reference/plane/sum.hpp
    lead: str
    entries: list[tuple[int, str]] = field(default_factory=list)  # line, Markdown

    @property
    def page(self) -> Path:
        return FOLDER / Path(self.path).relative_to("reference").with_suffix(".md")

    def text(self) -> str:
        up = "../" * (len(self.page.parts) - 1)
        top = (
            f"# {Path(self.path).name}\n\n{self.lead}\n\n"
            f'```cpp\n#include "{self.path}"\n```\n\nSource: [{self.path}]({up}{self.path}.md)\n'
        )
        return "\n".join([top, *(text for _, text in sorted(self.entries))])


def headers(root: Path) -> list[Header]:
    """The installed headers that declare something. Runs doxygen."""
    found: dict[str, Header] = {}
    for path in sorted((root / "reference").rglob("*.hpp")):
        name = str(path.relative_to(root))
        found[name] = Header(name, _lead(path))
    with tempfile.TemporaryDirectory() as folder:
        settings = (root / "docs/site/Doxyfile").read_text(encoding="utf-8")
        done = subprocess.run(
            ["doxygen", "-"],
            input=f"{settings}\nOUTPUT_DIRECTORY = {folder}\n",
            cwd=root,
            check=False,
            capture_output=True,  # its warnings are about specializations of templates of others
            text=True,
        )
        if done.returncode:
            raise SystemExit(f"minkref: doxygen failed\n{done.stderr}")
        for path in sorted(Path(folder, "xml").glob("*.xml")):
            compound = ElementTree.parse(path).getroot().find("compounddef")
            if compound is not None:
                _read(compound, found)
    return [header for header in found.values() if header.entries]


def index(all_headers: list[Header]) -> str:
    rooms: dict[str, list[Header]] = defaultdict(list)
    for header in all_headers:
        rooms[str(Path(header.path).parent)].append(header)
    text = (
        "# The C++ library\n\n`find_package(minkref)` gives the target `minkref::reference`; "
        "everything is in the namespace `minkref`, in which `plane`, `paths`, `disc` and `space` "
        "are inline. "
        "Start with [plane/sum.hpp](plane/sum.md), "
        "or with [the tutorial](../../docs/tutorials/cpp.md). "
        "These pages are made from the headers.\n"
    )
    for room, members in sorted(rooms.items()):
        text += f"\n## {room}\n\n| Header | What it declares |\n|---|---|\n"
        for header in members:
            lead = header.lead.replace("\n", " ").replace("|", "\\|")
            link = header.page.relative_to(FOLDER)
            text += f"| [{Path(header.path).name}]({link}) | {lead} |\n"
    return text


def _lead(path: Path) -> str:
    """The comment that the header begins with."""
    lines = []
    for line in path.read_text(encoding="utf-8").splitlines():
        if not line.startswith("//"):
            break
        lines.append(line.lstrip("/ "))
    return _plain("\n".join(lines))


def _plain(text: str) -> str:
    """Nothing of it is HTML, emphasis or a link."""
    for letter in "\\*_<>[]":
        text = text.replace(letter, f"\\{letter}" if letter not in "<>" else escape(letter))
    return text


def _read(compound: Element, found: dict[str, Header]) -> None:
    kind = compound.get("kind")
    if kind == "namespace":
        for member in compound.iter("memberdef"):
            _add(found, member, _member(member, 2))
    elif kind in ("class", "struct") and compound.get("prot", "public") == "public":
        members = [
            member
            for section in compound.iter("sectiondef")
            if section.get("kind", "").startswith(("public", "user-defined", "friend"))
            for member in section.iter("memberdef")
            if member.get("prot") == "public"
        ]
        members.sort(key=lambda member: _place(member)[1])
        name = _words(compound, "compoundname").removeprefix("minkref::")
        parts = [_entry(2, name, f"{_template(compound)}{kind} {name}", _description(compound))]
        fields = [m for m in members if m.get("kind") == "variable"]
        if fields:
            parts.append("| Member | Type | |\n|---|---|---|")
            parts[-1] += "".join(_row(member) for member in fields)
        parts += [
            _member(m, 3) for m in members if m.get("kind") in ("function", "enum", "typedef")
        ]
        _add(found, compound, "\n\n".join(part for part in parts if part))


def _add(found: dict[str, Header], element: Element, text: str) -> None:
    file, line = _place(element)
    if text and file in found:
        found[file].entries.append((line, f"\n{text}\n"))


def _place(element: Element) -> tuple[str, int]:
    location = element.find("location")
    if location is None:
        return "", 0
    return (
        location.get("declfile", location.get("file", "")),
        int(location.get("declline", location.get("line", "0"))),
    )


def _member(member: Element, level: int) -> str:
    kind, name = member.get("kind", ""), _words(member, "name")
    if kind == "enum":
        values = member.findall("enumvalue")
        listed = ",\n".join(
            f"  {_words(v, 'name')} {_words(v, 'initializer')}".rstrip() for v in values
        )
        text = _entry(level, name, f"enum class {name} {{\n{listed}\n}}", _description(member))
        told = [(_words(value, "name"), _description(value)) for value in values]
        items = "\n".join(f"- `{one}`: {' '.join(what.split())}" for one, what in told if what)
        return f"{text}\n\n{items}"
    if kind == "typedef":
        declared = f"using {name} = {_words(member, 'type')}"
    elif kind == "variable":
        declared = f"{_words(member, 'type')} {name} {_words(member, 'initializer')}".rstrip()
    elif kind == "function":
        declared = _template(member) + _signature(member)
    else:
        return ""
    return _entry(level, name, declared, _description(member))


def _signature(member: Element) -> str:
    words = [word for word in ("static", "explicit") if member.get(word) == "yes"]
    words += ["virtual"] if member.get("virt") in ("virtual", "pure-virtual") else []
    words += [_words(member, "type")] if _words(member, "type") else []
    name, arguments = _words(member, "name"), _words(member, "argsstring")
    line = " ".join([*words, name]) + arguments.replace(" &", "& ").replace(" *", "* ")
    if len(line) <= 100 or not member.findall("param"):
        return line
    parameters = [
        f"{_words(p, 'type')} {_words(p, 'declname')}"
        + (f" = {_words(p, 'defval')}" if p.find("defval") is not None else "")
        for p in member.findall("param")
    ]
    end = arguments[arguments.rindex(")") :]
    return " ".join([*words, name]) + "(\n    " + ",\n    ".join(parameters) + end


def _template(element: Element) -> str:
    listed = element.find("templateparamlist")
    if listed is None:
        return ""
    parameters = [
        f"{_words(p, 'type')} {_words(p, 'declname')}".strip() for p in listed.findall("param")
    ]
    return f"template <{', '.join(parameters)}>\n"


def _entry(level: int, name: str, declared: str, description: str) -> str:
    """A heading, the declaration and what is said of it."""
    return f"{'#' * level} {_plain(name)}\n\n```cpp\n{declared}\n```\n\n{description}".rstrip()


def _row(member: Element) -> str:
    told = " ".join(_description(member).split()).replace("|", "\\|")
    type_name = _words(member, "type").replace("|", "\\|")
    return f"\n| `{_words(member, 'name')}` | `{type_name}` | {told} |"


def _words(element: Element, tag: str) -> str:
    part = element.find(tag)
    return "" if part is None else " ".join("".join(part.itertext()).split())


def _description(element: Element) -> str:
    texts = []
    for tag in ("briefdescription", "detaileddescription"):
        part = element.find(tag)
        if part is not None:
            texts += [_block(block) for block in part]
    return "\n\n".join(text for text in texts if text)


def _block(element: Element) -> str:
    """A paragraph, list or piece of code of doxygen, as Markdown."""
    if element.tag in ("itemizedlist", "orderedlist"):
        items = [" ".join(_inline(item).split()) for item in element]
        return "\n".join(f"- {item}" for item in items)
    if element.tag in ("verbatim", "preformatted", "programlisting"):
        return f"```\n{''.join(element.itertext())}\n```"
    inner = [
        child
        for child in element
        if child.tag in ("itemizedlist", "orderedlist", "verbatim", "preformatted")
    ]
    blocks = [_block(child) for child in inner]
    for child in inner:
        element.remove(child)
    return "\n\n".join(text for text in (_inline(element).strip(), *blocks) if text)


def _inline(element: Element) -> str:
    text = _plain(element.text or "")
    for child in element:
        inside = _inline(child)
        if child.tag == "computeroutput":
            inside = f"`{''.join(child.itertext())}`"
        elif child.tag in ("emphasis", "bold"):
            inside = f"*{inside}*" if child.tag == "emphasis" else f"**{inside}**"
        elif child.tag in ("superscript", "subscript"):
            inside = f"<{child.tag[:3]}>{inside}</{child.tag[:3]}>"
        text += inside + _plain(child.tail or "")
    return text
