"""`minkref view PART OBSTACLES --path PATH`: a part on a path as a page, with the places and
scales at which it collides."""

from __future__ import annotations

from typing import Any

from minkref.cli.memory import SMALLER, memory_wall
from minkref.cli.output import give, print_lines
from minkref.errors import refusing
from minkref.exact import text_of_bounds
from minkref.motion.commands.path_rows import number_text, range_documents, ranges_text
from minkref.motion.page.picture import PathQuestion, picture, window_around
from minkref.motion.page.write_page import page
from minkref.motion.path_text import read_path
from minkref.motion.scale_ranges import CONTACTS
from minkref.output.documents import Stopwatch, document, refuse_overwriting
from minkref.output.terminal import counted
from minkref.plane.operand import read_operand
from minkref.verbs.path import check_words
from minkref.verbs.view import ViewWithPath, page_target


def run(request: ViewWithPath) -> None:
    watch = Stopwatch()
    part, obstacles, path = request.P, request.Q, request.path
    contact = request.contact or CONTACTS[0]
    assert path is not None  # it chooses this page
    target = page_target(request.output, request.json)
    check_words(contact=(contact, CONTACTS))
    ends = text_of_bounds(request.from_scale, request.to_scale)
    first, second, way = read_operand(part), read_operand(obstacles), read_path(path)
    if not target.is_standard_output:
        files = [first.file, second.file, *([way.file] if way.file else [])]
        refuse_overwriting(target.path, files)
    where = f"{part}, {obstacles}"
    question = PathQuestion(first.set, second.set, way.points, contact)
    with memory_wall(request.memory, "the path", f"{part} and {obstacles}", SMALLER):
        ranges, bounds = refusing(where, question.valid)
        shown = window_around(bounds, ends[0], ends[1])
        data = refusing(where, lambda: picture(question, ranges, bounds, shown))
        valid = ranges_text(range_documents(ranges))
        count = target.write_pieces([page(first.name, second.name, way.name, valid, data)])
    if target.is_standard_output:
        return
    value = document(
        "view",
        watch,
        part=first.name,
        obstacles=second.name,
        path=way.name,
        contact=contact,
        **{"from": shown.first, "to": shown.last},
        valid=range_documents(ranges),
        bounds=len(bounds),
        polygons=len(data["polygons"]),
        warnings=first.warnings + second.warnings,
        output=str(target.path),
        bytes=count,
    )
    give(value, request.json, _print)


def _print(value: dict[str, Any]) -> None:
    first, last = number_text(value["from"]), number_text(value["to"])
    rows = [
        ("part", f"{value['part']} among {value['obstacles']}, contact {value['contact']}"),
        ("path", value["path"]),
        ("valid scales", ranges_text(value["valid"])),
        ("shown", f"[{first}, {last}], {counted(value['polygons'], 'bad polygon')}"),
        ("seconds", f"{value['seconds']:.3f}"),
        ("written", f"{value['output']}, {value['bytes']:,} bytes"),
    ]
    print_lines(rows, value)
