"""A run's cases: generated cases, small first, with cases derived from them; the shipped models;
the paper's kind of input; case files."""

from __future__ import annotations

import itertools
import random
import time
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from enum import Enum

from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.verbs import EVENTS, UPDATE
from minkref.fuzz.space.case import LAWS_IN_SPACE
from minkref.model_catalogue import PAPER_MODELS, all_models, or_look_alike

SMALL_MODELS = ("g3", "g1", "disc1", "disc5", "g2", "g4", "dog145")
REAL_PAIRS = (("disc1", "neuron"), ("disc5", "neuron"), ("monkey", "bird"))
REAL_SCALES = ("1/3", "1", "7/5", "541/186", "9")
RANDOM = "random"  # the family of the first hour
MUTANTS_PER_ROUND = 12
MOST_PARENTS = 200
DEEPEST_MUTANT = 4
AXES_PER_ROUND = 4  # families with a factor for each axis
PROBES_PER_ROUND = 3
PATHS_PER_ROUND = 3  # per verb
SETS_PER_ROUND = 3  # per family of sets to unite, to grow, or with features
GRID_BITS = 24  # for cases on a grid, or in doubles
CONVEX_FAMILIES = ("space-convex", "space-sphere")  # taken by most targets with updates
TOUCHING = "passing"  # the family with topology events of the kind `touch`
CONVEX = "convex"
FAR_AND_LARGE = (  # each in every second round
    ("scaled-up:210", "far out"),
    ("cut:100", "many vertices"),
    ("scaled-down:90", "far in"),
    ("cut:300", "many vertices"),
)
MOST_TRIES = 20  # cases made for each requested case
FEWEST_TRIES = 500
SPACE_ROUNDS = 3  # rounds in which each family in space has a turn, beside the plane's families


class Wait(Enum):
    """Between two rounds: what follows depends on the results of all before."""

    FOR_ALL = "for all"


@dataclass
class CaseList:
    """A run's cases. Generated cases come from `families` in turn, bounded by `seconds`, or by
    `pairs`: the number of cases that exist and that a target takes. With `derived`, generated cases
    include probes of scales at events, cases changed by laws, and mutants of cases that `learn`
    found interesting; everything depends on the seed and the results alone, not on time."""

    seed: int = 1
    pairs: int | None = None
    seconds: float = 150.0
    named: tuple[str, ...] = ()
    models: bool = True
    families: tuple[str, ...] = (RANDOM,)
    space: tuple[str, ...] = ()
    laws: tuple[str, ...] = ()
    derived: bool = False
    files: tuple[str, ...] = ()
    invalid: bool = False  # also pairs with one invalid operand
    paths: tuple[str, ...] = ()  # verbs of paths
    unions: tuple[str, ...] = ()  # families of sets to unite
    offsets: tuple[str, ...] = ()  # families of sets to grow
    features: tuple[str, ...] = ()  # families of sets whose features are asked for
    doubles: bool = False  # no target takes other numbers: each pair on a grid, too
    spent: float = 0.0  # seconds used by an earlier part of the run
    begin: int = 0  # the first round of generated cases
    rounds: int | None = None  # how many; None: without end
    notes: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        self._rest = [] if self.named else self._model_cases() if self.models else []
        self._seen: set[str] = set()
        self._learned: list[tuple[int, str, str]] = []
        self._parents: list[str] = []
        self._missing = 0
        self.generating = False

    def __iter__(self) -> Iterator[CaseName | Wait]:
        if self.named:
            yield from (CaseName(text, "named") for text in self.named)
            return
        yield from (CaseName(text, "case files") for text in self.files)
        self.generating = True
        yield from self._bounded(time.monotonic() + self.seconds - self.spent)
        self.generating = False
        yield from self._rest

    def _bounded(self, end: float) -> Iterator[CaseName | Wait]:
        """Yields generated cases until there are enough, or time is over. When the number may
        suffice, waits for all results: the end does not depend on the order in which they come."""
        count = 0
        for name in self._generated():
            if isinstance(name, Wait):
                yield name
                continue
            if self.pairs is None:
                if time.monotonic() >= end:
                    break
            elif count - self._missing >= self.pairs:
                if count:
                    yield Wait.FOR_ALL
                if count - self._missing >= self.pairs:
                    break
            if self.pairs is not None and count >= MOST_TRIES * self.pairs + FEWEST_TRIES:
                yield Wait.FOR_ALL
                self.notes.append(
                    f"{count:,} cases were made, and the targets take {count - self._missing:,}"
                )
                break
            yield name
            count += 1

    @property
    def count(self) -> int | None:
        """Returns the number of cases, if known beforehand."""
        if self.named:
            return len(self.named)
        if self.pairs is None:
            return None
        return self.pairs + len(self._rest) + len(self.files)

    def head(self) -> dict[str, object]:
        """Returns the settings that distinguish runs."""
        names = ("seed", "pairs", "seconds", "named", "models", "families", "space", "laws")
        head: dict[str, object] = {name: getattr(self, name) for name in names}
        more = ("derived", "files", "invalid", "paths", "unions", "offsets", "features", "doubles")
        return {**head, **{name: getattr(self, name) for name in more}}

    def miss(self) -> None:
        """Notes that a generated case does not exist, or that no target takes it."""
        self._missing += self.generating

    def learn(self, number: int, text: str, coverage: str | None) -> None:
        """Notes what a case showed. The order of results does not matter."""
        if self.derived and coverage is not None:
            self._learned.append((number, text, coverage))

    def _generated(self) -> Iterator[CaseName | Wait]:
        sets = self.families or self.space or self.unions or self.offsets or self.features
        if not sets and self.rounds is None:
            return
        if not self.derived:
            for index in self._indices():
                for family in (*self.families, *self.space):
                    yield CaseName(f"{family}:{self.seed}:{index}", family)
                if self.invalid:
                    yield CaseName(f"invalid:{self.seed}:{index}", "invalid input")
                yield from self._paths(index)
                yield from self._of_sets(index)
            return
        for index in self._indices():
            yield from self._round(index)
            yield Wait.FOR_ALL
            self._choose_parents()

    def _indices(self) -> Iterable[int]:
        if self.rounds is None:
            return itertools.count(self.begin)
        return range(self.begin, self.begin + self.rounds)

    def _round(self, index: int) -> Iterator[CaseName]:
        """Yields one case per family, and cases derived from some."""
        dice = random.Random(f"minkref round {self.seed} {index}")
        texts = {family: f"{family}:{self.seed}:{index}" for family in self.families}
        for family in self.families:
            yield CaseName(texts[family], family)
            if self.doubles:
                yield CaseName(f"grid:{GRID_BITS}({texts[family]})", "on a grid")
        rounds = SPACE_ROUNDS if self.families else 1
        for family in self.space[index % rounds :: rounds]:
            yield CaseName(f"{family}:{self.seed}:{index // rounds}", family)
        if self.invalid:
            yield CaseName(f"invalid:{self.seed}:{index}", "invalid input")
        yield from self._paths(index)
        yield from self._of_sets(index)
        for family in dice.sample(self.families, min(PROBES_PER_ROUND, len(self.families))):
            for probe in sorted(dice.sample(range(9), 3)):
                text = f"probe:{probe}({texts[family]})"
                yield CaseName(text, family)
                yield CaseName(f"grid:{GRID_BITS}({text})", "on a grid")
        yield from self._far_and_large(index, texts, dice)
        yield from self._by_axes(index, texts)
        for law in self.laws if self.families else ():
            family = dice.choice(self.families)
            yield CaseName(f"{law}({texts[family]})", "laws")
        if EVENTS in self.laws and TOUCHING in texts:
            yield CaseName(f"{EVENTS}({texts[TOUCHING]})", "laws")
        if self.space and self.laws:
            family, law = dice.choice(self.space), dice.choice(LAWS_IN_SPACE)
            yield CaseName(f"{law}({family}:{self.seed}:{index // 2})", "laws in space")
        if self.space and UPDATE in self.laws:
            convex = [family for family in CONVEX_FAMILIES if family in self.space]
            for families in filter(None, (convex, self.space)):
                family = families[index % len(families)]
                yield CaseName(f"{UPDATE}({family}:{self.seed}:{index // 2})", "updates in space")
        for k in range(min(MUTANTS_PER_ROUND, len(self._parents))):
            parent = dice.choice(self._parents)
            yield CaseName(f"mutant:{index * MUTANTS_PER_ROUND + k}({parent})", "mutants")

    def _paths(self, index: int) -> Iterator[CaseName]:
        """Yields several small cases per round, of four kinds."""
        end = "-grid" if self.doubles else ""
        for verb in self.paths:
            for k in range(PATHS_PER_ROUND):
                number = index * PATHS_PER_ROUND + k
                yield CaseName(f"{verb}{end}:{self.seed}:{number}", "paths")

    def _of_sets(self, index: int) -> Iterator[CaseName]:
        for group, families in self._groups():
            for family in families:
                for k in range(SETS_PER_ROUND):
                    number = index * SETS_PER_ROUND + k
                    yield CaseName(f"{family}:{self.seed}:{number}", group)

    def _groups(self) -> tuple[tuple[str, tuple[str, ...]], ...]:
        return ("unions", self.unions), ("offsets", self.offsets), ("features", self.features)

    def _by_axes(self, index: int, texts: dict[str, str]) -> Iterator[CaseName]:
        """Yields cases of some families with a factor for each axis, and updates to such."""
        dice = random.Random(f"minkref axes {self.seed} {index}")
        for family in dice.sample(self.families, min(AXES_PER_ROUND, len(self.families))):
            yield CaseName(f"axes:{index}({texts[family]})", family)
        if UPDATE in self.laws and CONVEX in texts:
            yield CaseName(f"{UPDATE}(axes:{index}({texts[CONVEX]}))", "laws")

    def _far_and_large(
        self, index: int, texts: dict[str, str], dice: random.Random
    ) -> Iterator[CaseName]:
        """Yields cases for this round, from drawn families, with numbers far from 1 and with many
        vertices."""
        for k, (change, group) in enumerate(FAR_AND_LARGE):
            if self.families and index % 2 == k % 2:
                family = dice.choice(self.families)
                yield CaseName(f"{change}({texts[family]})", group)

    def _choose_parents(self) -> None:
        """Chooses cases that showed something new, ordered by number."""
        for _, text, coverage in sorted(self._learned):
            if coverage in self._seen:
                continue
            self._seen.add(coverage)
            if text.count("mutant:") < DEEPEST_MUTANT and not text.startswith(self.laws or ("(",)):
                self._parents.append(text)
        self._learned.clear()
        self._parents = self._parents[-MOST_PARENTS:]

    def _model_cases(self) -> list[CaseName]:
        known = all_models()
        small = [name for name in SMALL_MODELS if name in known]
        cases = [
            CaseName(f"{P}+{Q}@1", "shipped models")
            for P, Q in itertools.combinations_with_replacement(small, 2)
        ]
        for first, second in REAL_PAIRS:
            P, Q = or_look_alike(first, known), or_look_alike(second, known)
            if P in known and Q in known:
                cases += [CaseName(f"{P}+{Q}@{scale}", f"{P} + {Q}") for scale in REAL_SCALES]
        for name, _, alike, _ in PAPER_MODELS:
            if name not in known:
                self.notes.append(
                    f"{name} is missing (MINKREF_MODELS does not provide it): {alike} is used "
                    f"instead"
                )
        missing = [name for name in SMALL_MODELS if name not in known]
        if missing:
            self.notes.append(f"models not found: {', '.join(missing)}")
        return cases
