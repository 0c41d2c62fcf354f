"""Limits of the numbers given to `minkref verify`."""

from __future__ import annotations

from collections.abc import Mapping

from minkref.errors import Refusal

MOST_JOBS = 1024
LARGEST_SEED = 2**63 - 1
MOST_MEMORY = 1 << 24  # MiB
MOST_PROCESSES = 1 << 20


def brief(number: float) -> str:
    """The number; of one of very many digits how many it has."""
    text = str(number)
    return text if len(text) <= 60 else f"a number of {len(text):,} digits"


#: Option: the least number, and the most.
RANGES: dict[str, tuple[int, int | None]] = {
    "--seconds": (0, None),
    "--pairs": (0, None),
    "--seed": (-LARGEST_SEED, LARGEST_SEED),
    "--jobs": (1, MOST_JOBS),
    "--call-memory": (16, MOST_MEMORY),
    "--call-output": (1, MOST_MEMORY),
    "--time-limit": (1, None),
    "--call-processes": (1, MOST_PROCESSES),
    "--memory": (256, MOST_MEMORY),
    "--size-limit": (1, None),
}


def check_numbers(given: Mapping[str, float | None]) -> None:
    """Refuses numbers out of range, by option; None is not given."""
    for option, (least, most) in RANGES.items():
        value = given.get(option)
        if value is not None and not value >= least:
            raise Refusal(f"{brief(value)} is too small", option, f"give at least {least}")
        if value is not None and most is not None and value > most:
            raise Refusal(f"{brief(value)} is too large", option, f"give at most {most}")
    seconds = given["--call-seconds"]
    if seconds is None or not 0 < seconds <= 86_400:
        raise Refusal(f"{seconds} is out of range", "--call-seconds", "give 0 to 86400 seconds")
