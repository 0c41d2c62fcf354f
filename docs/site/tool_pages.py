"""The command line as typer describes it, and the JSON schemas of what `--json` prints."""

from __future__ import annotations

import json
import re
import subprocess
from collections.abc import Iterator
from pathlib import Path

import jsonschema_markdown
from loguru import logger

COMMAND_LINE = Path("api/command-line.md")
SCHEMAS = Path("api/schemas")
WORDS = {  # of the library, and ours
    "JSON Schema missing a description, provide it using the `description` key in the root of the "
    "JSON document.\n": "",
    "No description provided for this model.\n": "",
    "\n---\n\n# Definitions": "\n## Definitions",
    "> \u26a0\ufe0f Additional properties are not allowed.": "No other properties are allowed.",
    "\u2705": "yes",
}
# Links to a service that explains patterns.
PATTERN = re.compile(r"\[(`[^`]+`)\]\(https://regex101\.com/[^)]*\)")
ALL_SCHEMAS = """
import json
from minkref.schemas import names, result_schema
print(json.dumps({name: result_schema(name) for name in sorted(names())}))
"""
COMMAND = re.compile(r"^(\.venv/bin/)?(\w+=\S+ )*(minkref|cat|echo|printf|python3?) ")


def command_line(root: Path) -> str:
    """All commands with their arguments, options and examples."""
    words = ["--app", "app", "minkref.cli.cli", "utils", "docs", "--name", "minkref"]
    done = subprocess.run(
        [root / ".venv/bin/typer", *words, "--title", "The command line"],
        check=True,
        stdout=subprocess.PIPE,
        text=True,
    )
    return "\n".join(_with_examples(done.stdout.splitlines())) + "\n"


def _with_examples(lines: list[str]) -> Iterator[str]:
    """Example commands, which typer gives as paragraphs, as blocks of code."""
    inside = fenced = False
    for line in lines:
        fenced ^= line.startswith("```")
        example = not fenced and COMMAND.match(line) is not None
        if example and not inside:
            yield "```console"
            inside = True
        if inside and not example and line.strip():
            yield "```\n"
            inside = False
        if not inside or example:
            yield f"$ {line}" if example else line
    if inside:
        yield "```"


def schema_pages(root: Path) -> Iterator[tuple[Path, str]]:
    """A page and a file for each schema, the index last."""
    logger.disable("jsonschema_markdown")  # it tells of forms that it shows as they are
    words = [str(root / ".venv/bin/python"), "-c", ALL_SCHEMAS]
    done = subprocess.run(words, check=True, stdout=subprocess.PIPE, text=True)
    listed = []
    for name, schema in json.loads(done.stdout).items():
        file = SCHEMAS / f"{name}.json"
        yield file, json.dumps(schema, indent=2) + "\n"
        text = jsonschema_markdown.generate(
            schema, title=schema["title"], footer=False, hide_empty_columns=True
        )
        for before, after in WORDS.items():
            text = text.replace(before, after)
        text = PATTERN.sub(r"\1", text)
        page = SCHEMAS / f"{name}-json.md"
        listed.append(f"- [{schema['title']}]({page.name})")
        yield page, f"{text.strip()}\n\n[The schema itself]({file.name})\n"
    yield (
        SCHEMAS / "README.md",
        "# JSON schemas\n\nEvery command prints one JSON document with `--json`, and the schema "
        "of that document with `--schema`. These pages are made from the schemas.\n\n"
        + "\n".join(listed)
        + "\n",
    )
