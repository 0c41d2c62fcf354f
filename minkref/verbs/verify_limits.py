"""Limits of the numbers given to `minkref verify`."""

from __future__ import annotations

from minkref.errors import Refusal

MOST_JOBS = 1024
LARGEST_SEED = 2**63 - 1
MOST_MEMORY = 1 << 24  # MiB
MOST_PROCESSES = 1 << 20


def brief(number: float) -> str:
    """The number; of one of very many digits how many it has."""
    text = str(number)
    return text if len(text) <= 60 else f"a number of {len(text):,} digits"


def check_numbers(
    seconds: float,
    pairs: int | None,
    jobs: int | None,
    call_seconds: float,
    call_memory: int,
    call_output: int,
    size_limit: int | None,
    memory: int | None = None,
    seed: int = 1,
    call_processes: int | None = None,
) -> None:
    for option, value, least, most in (
        ("--seconds", seconds, 0, None),
        ("--pairs", pairs, 0, None),
        ("--seed", seed, -LARGEST_SEED, LARGEST_SEED),
        ("--jobs", jobs, 1, MOST_JOBS),
        ("--call-memory", call_memory, 16, MOST_MEMORY),
        ("--call-output", call_output, 1, MOST_MEMORY),
        ("--call-processes", call_processes, 1, MOST_PROCESSES),
        ("--memory", memory, 256, MOST_MEMORY),
        ("--size-limit", size_limit, 1, None),
    ):
        if value is not None and not value >= least:
            raise Refusal(f"{brief(value)} is too small", option, f"give at least {least}")
        if value is not None and most is not None and value > most:
            raise Refusal(f"{brief(value)} is too large", option, f"give at most {most}")
    if not 0 < call_seconds <= 86_400:
        raise Refusal(
            f"{call_seconds} is out of range", "--call-seconds", "give 0 to 86400 seconds"
        )
