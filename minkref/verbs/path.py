"""`minkref path ROBOT OBSTACLES PATH`: the scales at which a part passes along a path."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any

import typer
from minkref import _core
from minkref.cli.memory import SMALLER, Memory, memory_wall
from minkref.cli.options import Json, Schema, WindowFrom, WindowTo
from minkref.cli.output import give, print_lines
from minkref.errors import Refusal, choice, refusing
from minkref.exact import read_window
from minkref.motion.commands.path_in_space import path_in_space
from minkref.motion.commands.path_proof import (
    Certify,
    proof_document,
    proof_files,
    proof_rows,
    proved,
)
from minkref.motion.commands.path_rows import (
    contact_document,
    extreme_scales,
    feature_text,
    number_text,
    point_text,
    range_documents,
    ranges_text,
)
from minkref.motion.path_text import read_path
from minkref.motion.scale_ranges import CONTACTS, PATH_ROUTES, range_values
from minkref.output.documents import (
    Stopwatch,
    as_text,
    document,
    lasting,
    refuse_overwriting,
    write_together,
)
from minkref.output.output_target import Target, target_of
from minkref.plane.operand import read_operand
from minkref.space.operand import in_space
from minkref.verbs.certificate_output import Checked

EXAMPLES = """Examples:

minkref path disc1 g2 "LINESTRING (-60 55, 60 55)"

minkref path part.wkt obstacles.wkt way.csv --contact forbidden --json

minkref path part.wkt obstacles.wkt way.geojson --route contacts -o valid.json

minkref path part.wkt obstacles.wkt way.geojson -o valid.svg

minkref path rod gs3 "LINESTRING Z (0 0 9, 0 0 0, 9 1/2 0)"

minkref path part.off obstacles.stl way.csv --contact forbidden --to 2

minkref path part.wkt obstacles.wkt way.csv --certify valid.cert.json"""

FORMS = ("json", "svg")  # that -o writes; in space the first
MOST_ROWS = 20

Robot = Annotated[str, typer.Argument(help="The part, scaled about its origin: a file or a model.")]
Obstacles = Annotated[str, typer.Argument(help="What it must not meet: a file or a model.")]
Contact = Annotated[
    str,
    typer.Option(
        "--contact", help="allowed: the part may touch; forbidden: it may not.", metavar="RULE"
    ),
]


def command(
    robot: Robot,
    obstacles: Obstacles,
    path: Annotated[
        str,
        typer.Argument(
            help="Polyline of the part's origin: WKT, GeoJSON or CSV, file or text; in space with "
            "three coordinates."
        ),
    ],
    contact: Contact = "allowed",
    from_scale: WindowFrom = None,
    to_scale: WindowTo = None,
    route: Annotated[
        str,
        typer.Option(
            "--route", help="pieces, contacts or index; in space the first two.", metavar="ROUTE"
        ),
    ] = "pieces",
    output: Annotated[
        Path | None,
        typer.Option(
            "-o",
            help="Write the document to this .json file, or to an .svg the diagram of places and "
            "scales that collide; - is standard output.",
            metavar="FILE",
        ),
    ] = None,
    certify: Certify = None,
    memory: Memory = None,
    json: Json = False,
    schema: Schema = False,
) -> None:
    """Find all scales at which a part passes along a polyline without a collision: its origin moves
    on the path, and it never turns. In the plane or in space. Exact: intervals with open and closed
    ends, single scales, and for each bound the contact that causes it."""
    watch = Stopwatch()
    window = read_window(from_scale, to_scale)
    space = in_space(robot, obstacles)
    routes = PATH_ROUTES[:2] if space and route != PATH_ROUTES[2] else PATH_ROUTES
    check_words(contact=(contact, CONTACTS), route=(route, routes))
    if space:
        if output is not None and output.suffix.lower() == ".svg":
            raise Refusal("no picture is drawn in space", str(output), "name a .json file")
        if certify is not None:
            raise Refusal("there is no certificate in space", "--certify", "leave it out")
        target = target_of(output, None, FORMS[:1], FORMS[0], json)
        value = path_in_space(watch, robot, obstacles, path, contact, window, route, output, memory)
        _finish(value, target, json)
        return
    target = target_of(output, None, FORMS, FORMS[0], json, has_format=False)
    first, second, way = read_operand(robot), read_operand(obstacles), read_path(path)
    files = [first.file, second.file, *([way.file] if way.file else [])]
    if output is not None:
        refuse_overwriting(output, files)
    proof = proof_files(certify, files, output)
    with memory_wall(memory, "the path", f"{robot} and {obstacles}", SMALLER):
        ranges, bounds, statistics = refusing(
            f"{robot}, {obstacles}",
            lambda: _core.valid_scales(
                first.set, second.set, way.points, contact, window[0], window[1], route
            ),
        )
        proven = proved(
            proof,
            (first.name, second.name),
            (first.set, second.set),
            way.points,
            lambda made: made.valid(contact, window[0], window[1], range_values(ranges)),
        )

    def drawn() -> str:
        from minkref.motion.page.diagram_svg import diagram_svg
        from minkref.motion.page.picture import PathQuestion, picture, window_around

        question = PathQuestion(first.set, second.set, way.points, contact)
        shown = window_around(bounds, window[0], window[1])
        where = f"{robot}, {obstacles}"
        data = refusing(where, lambda: picture(question, ranges, bounds, shown))
        return diagram_svg(data)

    value = document(
        "path",
        watch,
        robot=first.name,
        obstacles=second.name,
        path=way.name,
        vertices=len(way.points),
        is_closed=len(way.points) > 1 and way.points[0] == way.points[-1],
        contact=contact,
        route=route,
        **{"from": window[0], "to": window[1]},
        motion="translations only, along the path",
        valid=range_documents(ranges),
        **extreme_scales(ranges),
        star_shaped=_core.star_shaped(first.set),
        bounds=[contact_document(row) for row in bounds],
        statistics=dict(statistics),
        warnings=first.warnings + second.warnings,
        output=None if output is None else str(output),
        certificate=proof_document(proven),
    )
    _finish(value, target, json, drawn, None if proven is None else proven[0])


def _finish(
    value: dict[str, Any],
    target: Target | None,
    json: bool,
    drawn: Callable[[], str] | None = None,
    proof: Checked | None = None,
) -> None:
    """Writes the proof and the file of -o, or none of them. `drawn`: what makes a picture."""
    files: dict[Path, str | bytes] = {} if proof is None else {**proof.contents()}
    text = ""
    if target is not None:
        picture = drawn if target.form == "svg" else None
        text = as_text(lasting(value)) if picture is None else picture()
        if not target.is_standard_output:
            files[target.path] = text
    write_together(files)
    if target is not None and target.is_standard_output:
        target.write(text)
        return
    give(value, json, _print)


def check_words(**options: tuple[str, tuple[str, ...]]) -> None:
    """Refuses an option whose word is none of those that it knows."""
    for name, (word, known) in options.items():
        if word not in known:
            raise Refusal(
                f"there is no {name} of this name", f"--{name} {word}", choice(word, known)
            )


def _print(value: dict[str, Any]) -> None:
    star = "star-shaped about its origin" if value["star_shaped"] else "not star-shaped"
    rows = [
        ("part", f"{value['robot']}, {star}"),
        ("path", f"{value['path']}, vertices {value['vertices']:,}, contact {value['contact']}"),
        ("valid scales", ranges_text(value["valid"])),
    ]
    for bound in value["bounds"][:MOST_ROWS]:
        at = bound["at"]
        part, obstacle = (
            feature_text(bound[one], "dimension" in value) for one in ("part", "obstacle")
        )
        touching = f"{part} of the part, {obstacle}"
        place = f"segment {at['segment']}, t = {number_text(at['t'])}, {point_text(at['point'])}"
        rows.append(
            (number_text(bound["scale"]), f"{bound['event']}: {touching} of the obstacles; {place}")
        )
    if len(value["bounds"]) > MOST_ROWS:
        rows.append(("more", f"{len(value['bounds']) - MOST_ROWS:,}; --json prints all"))
    if value["output"]:
        rows.append(("written", value["output"]))
    rows += proof_rows(value)
    rows.append(("seconds", f"{value['seconds']:.3f}"))
    print_lines(rows, value)
