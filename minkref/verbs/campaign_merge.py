"""`minkref campaign merge`: joins ledgers from several machines."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import typer
from minkref.cli.options import Json, Schema
from minkref.output.exits import ExitCode

EXAMPLES = """Examples:

minkref campaign merge first second -o nightly

minkref campaign run nightly.toml -o nightly"""

Sources = Annotated[
    list[Path],
    typer.Argument(help="Folders of campaigns; they stay as they are.", metavar="DIR..."),
]
Output = Annotated[
    Path, typer.Option("-o", "--output", help="Folder that gets all of them.", metavar="DIR")
]


def command(folders: Sources, output: Output, json: Json = False, schema: Schema = False) -> None:
    """Join folders: shares of a campaign, or campaigns with other versions. Repeated chunks are
    kept once; the next `minkref campaign run` counts new ones. Exits with 1 if a repeated chunk
    differs in more than times."""
    from minkref.cli.output import give
    from minkref.fuzz.campaign.folder import heads
    from minkref.fuzz.ledgers.merging import merge_parts
    from minkref.output.documents import Stopwatch, document
    from minkref.output.output_folder import held_folder
    from minkref.output.terminal import console, counted, escaped

    watch = Stopwatch()
    campaigns = dict.fromkeys(head["id"] for folder in folders for head in heads(folder))
    with held_folder(output):
        _copy(folders, output, campaigns)
        merged = merge_parts(folders, output)
    value = document(
        "campaign_merge",
        watch,
        output=str(output),
        campaigns=list(campaigns),
        chunks=merged.chunks,
        repeated=merged.repeated,
        differing=list(merged.differing),
    )

    def shown(_: object) -> None:
        told = [counted(merged.chunks, "chunk"), counted(len(campaigns), "campaign")]
        told.append(f"{merged.repeated:,} in several folders")
        lines = [f"{output}: {', '.join(told)}"]
        lines += [f"{name} differs: a target does not repeat itself" for name in merged.differing]
        console().print("\n".join(map(escaped, lines)), soft_wrap=True)

    give(value, json, shown)
    if merged.differing:
        raise typer.Exit(int(ExitCode.WRONG))


def _copy(folders: Sequence[Path], output: Path, campaigns: dict[str, None]) -> None:
    """Copies heads and shrunk findings. Counts are made anew from the ledger."""
    from minkref.fuzz.campaign.folder import head_path, read_json, state_path, write_json

    for folder in folders:
        if folder.resolve() == output.resolve():
            continue
        for campaign in campaigns:
            places = [head_path(folder, campaign), *(folder / "kinds" / campaign).glob("*.json")]
            for path in places:
                copy = output / path.relative_to(folder)
                if path.is_file() and not copy.exists():
                    write_json(copy, read_json(path))
    for campaign in campaigns:
        state_path(output, campaign).unlink(missing_ok=True)
