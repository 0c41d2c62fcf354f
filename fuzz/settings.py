"""The settings that there are. One more is a folder and a line here."""

from __future__ import annotations

from typing import Any

from minkref.fuzz.cases.any_case import AnyCase
from minkref.fuzz.plane.setting import PLANE
from minkref.fuzz.setting import Setting
from minkref.fuzz.space.setting import SPACE
from minkref.fuzz.targets.asking import Asking

SETTINGS: tuple[Setting, ...] = (PLANE, SPACE)


def setting_of(dimension: int) -> Setting:
    return next(setting for setting in SETTINGS if setting.dimension == dimension)


def setting_of_document(value: Any) -> Setting:
    """Of a case file; the plane where it says nothing of another."""
    return next((s for s in reversed(SETTINGS) if s.is_document(value)), PLANE)


def setting_of_operands(operands: list[Any]) -> Setting:
    """Of JSON values; the plane where they look like nothing else."""
    return next((s for s in reversed(SETTINGS) if s.holds(operands)), PLANE)


def asking_about(case: AnyCase, *how: Any) -> Asking:
    """What Asking takes, in the setting of the case."""
    return setting_of(case.dimension).asking(case, *how)
