"""All settings, and questions other than sums. To add one, write a folder and a line here."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from minkref.fuzz.cases.any_case import AnyCase
from minkref.fuzz.features.question import FEATURES
from minkref.fuzz.invalid.question import REFUSALS
from minkref.fuzz.motion.question import PATHS
from minkref.fuzz.offsets.question import OFFSETS
from minkref.fuzz.plane.setting import PLANE
from minkref.fuzz.setting import Question, Setting, ShrinkableQuestion, SmallCase
from minkref.fuzz.space.setting import SPACE
from minkref.fuzz.targets.asking import Asking
from minkref.fuzz.unions.question import UNIONS

SETTINGS: tuple[Setting, ...] = (PLANE, SPACE)
QUESTIONS: tuple[Question, ...] = (PATHS, UNIONS, OFFSETS, FEATURES, REFUSALS)
SHRINKABLE: tuple[ShrinkableQuestion, ...] = (PATHS, UNIONS, OFFSETS, FEATURES)


def setting_of(dimension: int) -> Setting:
    return next(setting for setting in SETTINGS if setting.dimension == dimension)


def setting_of_document(value: Any) -> Setting:
    """The setting of a case file; the plane if the file says nothing of another."""
    return next((s for s in reversed(SETTINGS) if s.is_document(value)), PLANE)


def setting_of_operands(operands: list[Any]) -> Setting:
    """The setting of JSON values; the plane if they look like nothing else."""
    return next((s for s in reversed(SETTINGS) if s.holds(operands)), PLANE)


def question_of(literal: str) -> ShrinkableQuestion | None:
    """Returns the question in a text that names a case; None if the text asks for a sum."""
    return next((question for question in SHRINKABLE if question.is_asked(literal)), None)


def asking_about(case: AnyCase, *how: Any) -> Asking:
    """Makes the Asking for the case's question or setting; `how`: all arguments of Asking."""
    own = (question.asking for question in QUESTIONS if isinstance(case, question.cases))
    return next(own, setting_of(case.dimension).asking)(case, *how)


def small_case(
    dimension: int, P: str, Q: str, scale: str, literal: str
) -> tuple[SmallCase, Callable[[Any], Iterator[Any]]]:
    """A case to be made smaller, and the valid candidates of one, the boldest first."""
    question = question_of(literal)
    if question is not None:
        return question.small_case(literal), question.smaller
    setting = setting_of(dimension)
    return setting.small_case(P, Q, scale), setting.smaller
