"""The JSON schema of a type, by msgspec."""

from __future__ import annotations

import json
import sys
from functools import cache
from typing import Any, is_typeddict

from minkref.schemas.documents import NAMED
from minkref.schemas.grammar import RULES
from msgspec.json import schema_components

Schema = dict[str, Any]
DRAFT = "https://json-schema.org/draft/2020-12/schema"


def made(document: type) -> Schema:
    """The schema of a document. Its title is the docstring, and what it refers to is in `$defs`."""
    parts: Schema = {}
    _schema_of(document, parts)
    top = parts.pop(document.__name__)
    title = top.pop("description").removesuffix(".")
    return {"$schema": DRAFT, "title": title, **top, "$defs": parts}


def _schema_of(kind: Any, parts: Schema) -> Schema:
    """Puts what the schema refers to into `parts`."""
    (schema,), objects = schema_components((kind,), schema_hook=_either)
    for name, each in objects.items():
        parts[name] = _object(name, _inside(each, parts))
    return _inside(schema, parts)


def _either(kinds: Any) -> Schema:
    return {"anyOf": list(kinds.kinds)}


def _object(name: str, schema: Schema) -> Schema:
    """An object without other properties than those of the class, in their order: msgspec sorts
    them by their names."""
    kind = _classes()[name]
    fields = list(kind.__annotations__)
    del schema["title"]
    if "description" in schema:  # a docstring
        schema["description"] = " ".join(schema["description"].split())
    schema["properties"] = {field: schema["properties"][field] for field in fields}
    schema["required"] = [field for field in fields if field in schema["required"]]
    return {**schema, "additionalProperties": False, **RULES.get(kind, {})}


@cache
def _classes() -> dict[str, type]:
    """The types of objects by their names, each of which is there once."""
    modules = [each for name, each in sys.modules.items() if name.startswith(f"{__package__}.")]
    kinds = [kind for each in modules for kind in vars(each).values() if is_typeddict(kind)]
    return {kind.__name__: kind for kind in kinds}


def _mended(value: Any, parts: Schema) -> Any:
    """The value of a schema, with references for what has a name."""
    if isinstance(value, list):
        return [_mended(each, parts) for each in value]
    if isinstance(value, dict):
        return _reference(value, parts) or _inside(value, parts)
    return _schema_of(value, parts) if isinstance(value, type) else value  # one of Either


def _inside(schema: Schema, parts: Schema) -> Schema:
    mended = {word: _mended(value, parts) for word, value in schema.items()}
    if isinstance(mended.get("enum"), list) and len(mended["enum"]) == 1:
        mended["const"] = mended.pop("enum")[0]
    if "prefixItems" in mended:
        del mended["items"]  # false: maxItems says the same, and the generator of the site knows it
    return mended


def _reference(schema: Schema, parts: Schema) -> Schema | None:
    """What stands for a value that has a name: a reference, and what is said of it here."""
    name, full = _named().get(_key(schema), ("", {}))
    said, here = full.get("description"), schema.get("description")
    if not name or (said and not here):
        return None
    if name not in parts:
        parts[name] = _inside(full, parts)
    return {"$ref": f"#/$defs/{name}", **({} if said == here else {"description": here})}


@cache
def _named() -> dict[str, tuple[str, Schema]]:
    schemas = schema_components(tuple(NAMED.values()))[0]
    return {_key(schema): (name, schema) for name, schema in zip(NAMED, schemas, strict=True)}


def _key(schema: Schema) -> str:
    """Equal for values that differ in what is said of them only."""
    bare = {word: value for word, value in schema.items() if word != "description"}
    return json.dumps(bare, sort_keys=True, default=repr)
