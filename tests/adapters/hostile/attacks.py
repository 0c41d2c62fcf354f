"""All attacks by adapters and functions, with the verdicts that the documents give them."""

from __future__ import annotations

from dataclasses import dataclass, replace

PASS, WRONG, ERRORED = "pass", "wrong", "errored"
CRASHED, LATE, MEMORY = "crashed", "timed-out", "out-of-memory"
NONE = "no-adapter"  # it does not begin: a refusal of the run
CONVEX = ("--family", "convex", "--pairs", "3", "--no-derived")
ALL_WAYS = (PASS, WRONG, ERRORED, CRASHED, LATE, MEMORY, "skipped", "pass-within")


@dataclass(frozen=True)
class Attack:
    """`verdicts`: the possible verdicts; none: the run does not begin, exit code 2. Things that the
    adapter may reach, in its own words: `inside` the sandbox, where all these things are its own
    and end with it, and `alone`, without a sandbox. `leaves`: without a sandbox, files in public
    folders or shared memory. `kills`: may end the run, without a sandbox and a separate user."""

    adapter: str
    verdicts: tuple[str, ...] = (PASS,)
    words: tuple[str, ...] = CONVEX
    told: str = ""
    inside: tuple[str, ...] = ()
    alone: tuple[str, ...] = ()
    leaves: bool = False
    kills: bool = False
    tty: bool = False
    quick: bool = False

    @property
    def title(self) -> str:
        return f"{self.adapter} {self.told}".strip()


def of(verdicts: tuple[str, ...], *adapters: str) -> list[Attack]:
    return [Attack(adapter, verdicts) for adapter in adapters]


def several(adapter: str, verdicts: tuple[str, ...], numbers: list[int]) -> list[Attack]:
    return [Attack(adapter, verdicts, told=f"first={number}") for number in numbers]


PROCESSES = [
    *of((PASS,), "ForksFifty", "DaemonWithoutEnvironment", "Relay", "ForksWhenTerminated"),
    *of((PASS,), "OwnSubreaper", "OwnNamespace", "ManyThreads"),
    Attack("ForksFifty", (PASS, NONE), (*CONVEX, "--call-processes", "20")),
    Attack("Daemon", quick=True),
    Attack("KillsItsSupervisor", (PASS, CRASHED), kills=True, quick=True),
    Attack("KillsItsGroup", (CRASHED,), kills=True),
    Attack("KillsAllInSight", (PASS, CRASHED), kills=True),
    Attack("TerminatesAllInSight", (PASS, CRASHED), kills=True),
    Attack("StopsAllInSight", (PASS, CRASHED, LATE), kills=True),
    Attack("TakesItsParentsFiles", (PASS, CRASHED), kills=True),
    *of((LATE,), "StopsItself", "HearsNothing"),
    *of((CRASHED,), "StoppedChild", "HoldsThePipes"),
    Attack("DiesWhileItsChildrenAnswer", (CRASHED, PASS, NONE)),
]
FORGERIES = [
    Attack("ForgesTheLedger", (WRONG,), quick=True),
    *of((WRONG,), "AppendsToTheLedger", "ForgesTheReport", "LinksTheReportElsewhere"),
    *of((WRONG,), "AnotherName", "NastyName"),
    Attack("WritesToOurOutput", (WRONG, NONE)),
    *of((PASS,), "LocksTheLedger"),
    *of((ERRORED,), "PrintsADocument", "NastyReason", "ObeyTheTerminal", "OtherSeq"),
    *of((ERRORED, PASS, WRONG), "AnswersAhead", "AnswersTwice", "AnswersBeforeItIsAsked"),
    *of((CRASHED,), "ObeyTheTerminalInTheLog"),
]
FLOODS = [
    Attack("Floods", (ERRORED,), quick=True),
    *of((ERRORED,), "FloodsOfEmptyLines", "HugeAnswer", "FloodsTheLog", "FloodsTheLogInSilence"),
    *of((ERRORED, PASS), "FloodsOfAnswers", "Deep"),
    *of((), "FloodsInHello"),
    *of((LATE,), "Drips", "HalfALine", "ReadsNothing"),
    *of((LATE, ERRORED), "HalfALineAndCloses", "ClosesAll"),
    Attack("NoText", (ERRORED, PASS, CRASHED), (*CONVEX[:3], "16", "--no-derived")),
    *of((ERRORED, WRONG, LATE, MEMORY, CRASHED, "undecided"), "ManyRings", "ManyVertices"),
    # Each answer may take the judge its two minutes.
    Attack(
        "LongDenominators",
        (ERRORED, WRONG, LATE, MEMORY, CRASHED, "undecided"),
        (*CONVEX[:3], "1", "--no-derived"),
    ),
    *of((CRASHED, LATE, ERRORED), "Empty"),
]
SPELLED = 100
PLANE = ("--family", "convex", "--pairs", str(SPELLED), "--no-derived")
SPACE = ("--family", "space-convex", "--pairs", str(SPELLED), "--no-derived")
UPDATES = tuple(f"update(convex:1:{k})" for k in range(SPELLED))
EVENTS = tuple(f"events(holes:1:{k})" for k in range(SPELLED))


def cases(names: tuple[str, ...]) -> tuple[str, ...]:
    return tuple(word for name in names for word in ("--case", name))


NUMBERS = [
    Attack("SpellsPolygons", (ERRORED,), PLANE),
    Attack("SpellsRings", (ERRORED,), PLANE),
    Attack("SpellsInDoubles", (ERRORED, WRONG), PLANE),
    Attack("SpellsUpdates", (ERRORED, PASS), cases(UPDATES)),
    Attack("SpellsEvents", (ERRORED,), cases(EVENTS)),
    Attack("SpellsSpace", (ERRORED,), SPACE),
    Attack("SpellsUpdatesInSpace", (ERRORED, WRONG), SPACE[:4]),
    Attack("SpellsIndices", (ERRORED,), SPACE),
    Attack("HugeNumbers", (WRONG, ERRORED), (*CONVEX[:3], "12", "--no-derived")),
    *several("SpellsTolerance", (), [0, 2, 3, 12, 29, 47]),
    *several("SpellsGridUnit", (), [0, 2, 47]),
    *several("SpellsGridLargest", (), [2, 12, 70]),
    *several("SpellsGridBits", (), [0, 2, 80]),
]
LIES = 44
NO_LIES = [11, 18, 23]  # another word, and grids that hold every case or few: odd, and allowed
DECLARED = [
    *several("Lies", (), [number for number in range(LIES) if number not in NO_LIES]),
    *several("Lies", (PASS,), NO_LIES),
    Attack("PromisesAll", ALL_WAYS, ("--pairs", "20")),
    Attack("HugeTolerance", ("pass-within", PASS, "undecided")),
    Attack("AnotherEachTime", (PASS, CRASHED, ERRORED)),
    Attack("RejectsAll", (WRONG,)),
    Attack("ReasonsAreNoTexts", (ERRORED, WRONG)),
]
SHARED = ("shared-memory", "messages", "semaphores", "queue", "posix-memory")
REACHING = [
    Attack("ReadsTheEnvironment", quick=True),
    Attack("ReachesTheNetwork", alone=("tcp", "udp", "unix", "interfaces"), quick=True),
    Attack("Listens"),
    Attack("TracesItsParents", inside=("trace", "memory")),
    Attack("Privileges", alone=("capabilities",)),
    Attack("ChangesTheTerminal", tty=True),
    Attack("SharesMemory", inside=SHARED, alone=SHARED, leaves=True),
    Attack(
        "WritesEverywhere",
        inside=("tmp", "shm", "run"),
        alone=("tmp", "shm", "var"),
        leaves=True,
        quick=True,
    ),
    Attack("FillsTheTemporaryFolder", (PASS, MEMORY, CRASHED, NONE)),
    *of((PASS,), "LeavesFiles", "LeavesFilesInTheWorkFolder", "SwapsTheTemporaryFolder"),
    *of((PASS,), "LeavesThroughLinks"),
]
EATING = of((MEMORY,), "EatsMemory", "EatsMemoryAsATree", "EatsMemoryOfDaemons", "EatsSharedMemory")
EATING += of((MEMORY, LATE, CRASHED), "EatsUnmappedMemory", "OpensFiles")
ENDINGS = [
    *several("Exits", (CRASHED,), [0, 2, 70, 130, 255]),
    *several("ExitsInHello", (), [0, 70]),
    *several("ExitsInLoad", (CRASHED,), [3]),
    *several("ExitsAtOnce", (), [0, 137]),
    *several("Dies", (CRASHED,), [2, 3, 4, 6, 9, 11, 13, 15, 31, 34]),
    *of((CRASHED,), "DumpsItsCore"),
    *of((), "HangsInHello"),
]


def functions(verdicts: tuple[str, ...], *names: str, kind: str = "py") -> list[Attack]:
    return of(verdicts, *(f"{kind}:functions:{name}" for name in names))


FUNCTIONS = [
    *functions((ERRORED,), "exits", "interrupts", "deep", "spoils_builtins", "returns_itself"),
    *functions((ERRORED,), "returns_objects", "returns_without_end"),
    *functions((CRASHED,), "exits_hard", "closes_everything", "returns_evil"),
    *functions((MEMORY,), "runs_out_of_memory"),
    *functions((WRONG,), "prints_answers", "traces", "changes_its_operands"),
    *functions((WRONG,), "spoils_the_reference"),
    *functions((WRONG, ERRORED, CRASHED), "forks"),
    *functions((ERRORED,), "rings_below_zero", "no_arrays", "not_finite", kind="so"),
    *functions((ERRORED,), "another_status", "size_below_zero", "size_beyond_memory", kind="so"),
    *functions((CRASHED,), "exits", "overflows_the_stack", "not_from_malloc", kind="so"),
    *functions((CRASHED, ERRORED), "writes_into_its_operands", kind="so"),
    *functions((CRASHED, ERRORED, MEMORY, LATE), "rings_beyond_memory", kind="so"),
]
# Attacks with words of the protocol itself, beyond the power of functions.
SPEAK = ("PrintsADocument", "NastyReason", "ObeyTheTerminal", "ObeyTheTerminalInTheLog", "OtherSeq")
SPEAK += ("AnswersAhead", "AnswersTwice", "AnswersBeforeItIsAsked", "DiesWhileItsChildrenAnswer")
OUTLIVED = {"EatsSharedMemory": (ERRORED,)}  # an exception ends an adapter, and no function
MISCHIEF = [
    replace(
        attack,
        adapter=f"py:mischief:{attack.adapter}",
        verdicts=OUTLIVED.get(attack.adapter, attack.verdicts),
    )
    for attack in (*PROCESSES, *FORGERIES, *REACHING, *EATING)
    if attack.adapter not in SPEAK
]
ATTACKS = [
    *(*PROCESSES, *FORGERIES, *FLOODS, *NUMBERS, *DECLARED, *REACHING, *EATING, *ENDINGS),
    *FUNCTIONS,
    *MISCHIEF,
]
