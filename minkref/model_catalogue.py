"""Models by name: shipped with the package, or from the folder MINKREF_MODELS."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from minkref.errors import Refusal

VARIABLE = "MINKREF_MODELS"

# The paper's own models: name, file in MINKREF_MODELS, our look-alike, description.
PAPER_MODELS = (
    ("monkey", "nazca_monkey.poly", "glyph1204", "the Nazca monkey of Behar & Lien 2012"),
    ("bird", "bird.poly", "glyph275", "the bird of Behar & Lien 2012"),
    ("neuron", "neuron.poly", "cells1815", "the neurons of Behar & Lien 2012"),
)
LOOK_ALIKES = {name: alike for name, _, alike, _ in PAPER_MODELS}


@dataclass(frozen=True)
class Model:
    name: str
    path: Path
    origin: str  # "shipped" or "MINKREF_MODELS"
    about: str


@dataclass(frozen=True)
class SpaceModel:
    """A convex polyhedron from an OFF file, not an operand in the plane."""

    name: str
    path: Path
    vertices: int
    facets: int
    about: str


def shipped_folder() -> Path | None:
    """Find the package's folder `models`."""
    folder = Path(__file__).resolve().parent / "models"
    return folder if (folder / "index.json").is_file() else None


def shipped_models() -> list[Model]:
    return [
        Model(entry["name"], path, "shipped", entry.get("what", ""))
        for path, entry in _index("models")
    ]


def shipped_polyhedra() -> list[SpaceModel]:
    return [
        SpaceModel(entry["name"], path, entry["vertices"], entry["facets"], entry.get("what", ""))
        for path, entry in _index("polyhedra")
    ]


def _index(kind: str) -> list[tuple[Path, dict[str, Any]]]:
    """List the files in a list of index.json, with their entries."""
    folder = shipped_folder()
    if folder is None:
        return []
    index = json.loads((folder / "index.json").read_text(encoding="utf-8"))
    return [(folder / entry["file"], entry) for entry in index[kind]]


def extra_models() -> list[Model]:
    """List the paper's models and all other readable files in the folder MINKREF_MODELS."""
    setting = os.environ.get(VARIABLE)
    if not setting:
        return []
    folder = Path(setting)
    if not folder.is_dir():
        raise Refusal(
            "the folder of models does not exist",
            f"{VARIABLE}={setting}",
            "name a folder that holds nazca_monkey.poly, bird.poly, neuron.poly, or unset it",
            "no-such-folder",
        )
    found = [
        Model(name, folder / file, VARIABLE, about)
        for name, file, _, about in PAPER_MODELS
        if (folder / file).is_file()
    ]
    named = {model.path.name for model in found}
    for path in _files(folder):
        if path.suffix in (".poly", ".wkt", ".geojson") and path.name not in named:
            found.append(Model(path.stem, path, VARIABLE, ""))
    return found


def _files(folder: Path) -> list[Path]:
    try:
        return sorted(folder.iterdir())
    except OSError as error:
        raise Refusal(
            f"the folder of models cannot be read: {error.strerror}",
            f"{VARIABLE}={folder}",
            "name a folder that you may read, or unset it",
            "no-such-folder",
        ) from error


def all_models() -> dict[str, Model]:
    """Map names to models; a shipped model wins over a file with the same name in
    MINKREF_MODELS."""
    models = {model.name: model for model in extra_models()}
    models.update({model.name: model for model in shipped_models()})
    return models


def find_model(name: str) -> Model | None:
    return all_models().get(name)


def or_look_alike(name: str, models: dict[str, Model]) -> str:
    """Return `name` if present, otherwise our look-alike."""
    return name if name in models else LOOK_ALIKES.get(name, name)
