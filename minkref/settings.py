"""The settings in which operands lie. A fifth one is a line here, and a request in the commands
that know it."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass

from minkref.disc.disc import is_disc
from minkref.plane.operand_text import STANDARD_INPUT
from minkref.scene.scene_name import names_scene
from minkref.space.ball import is_ball
from minkref.space.operand import in_space


@dataclass(frozen=True)
class Setting:
    """`takes(operands, options)`: tell whether operands belong to the setting; `where`: the
    setting in messages."""

    name: str
    where: str
    takes: Callable[[Sequence[str], Collection[str]], bool]


FEATURES = Setting(
    "features",
    "with --features",
    lambda operands, given: "--features" in given and not _is_told_scene(*operands),
)
SCENE = Setting(
    "scene", "for a scene", lambda operands, given: len(operands) == 1 and names_scene(*operands)
)
MOTION = Setting("motion", "with a path", lambda operands, given: "--path" in given)
BALL = Setting("ball", "with a ball", lambda operands, given: any(map(is_ball, operands)))
DISC = Setting("disc", "with a disc", lambda operands, given: any(map(is_disc, operands)))
SPACE = Setting("space", "in space", lambda operands, given: in_space(*operands))
PLANE = Setting("plane", "in the plane", lambda operands, given: True)

ALONE = (FEATURES, SCENE)  # of a single operand
SETTINGS = (*ALONE, MOTION, BALL, DISC, SPACE, PLANE)  # the first one that takes the operands


def _is_told_scene(*operands: str) -> bool:
    """Standard input may be any operand."""
    return len(operands) == 1 and operands[0] != STANDARD_INPUT and names_scene(*operands)


def setting_of(
    operands: Sequence[str], given: Collection[str], known: Collection[Setting]
) -> Setting | None:
    """Choose a setting among those known to a command; None for a single operand that no setting
    takes. Refuses operands of two settings."""
    alone = len(operands) == 1
    found = (s for s in SETTINGS if s in known and (s in ALONE) == alone)
    return next((s for s in found if s.takes(operands, given)), None)
