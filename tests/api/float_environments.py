"""A thread's floating-point environment as another library may leave it. As a plugin, `pytest -p
float_environments`, it makes every test run in a thread that flushes subnormal numbers."""

from __future__ import annotations

import ctypes
import platform
import struct
from collections.abc import Iterator
from contextlib import contextmanager

import pytest

KNOWN = (platform.system(), platform.machine()) == ("Linux", "x86_64")  # glibc's layout of fenv_t
DOWN, UP, TO_ZERO = 0x2000, 0x4000, 0x6000  # of the word MXCSR
FLUSH = 0x8040  # results and operands
WAYS = {"down": DOWN, "up": UP, "to zero": TO_ZERO, "flushed": FLUSH, "flushed, up": FLUSH | UP}
WORD = struct.Struct("<28xI")  # where it stands in fenv_t


@contextmanager
def environment(bits: int) -> Iterator[None]:
    """This thread as a library may leave it."""
    libm = ctypes.CDLL("libm.so.6")
    before = ctypes.create_string_buffer(32)
    libm.fegetenv(before)
    changed = ctypes.create_string_buffer(before.raw, 32)
    (word,) = WORD.unpack_from(before.raw)
    struct.pack_into("<I", changed, 28, (word & ~0xE040) | bits)
    libm.fesetenv(changed)
    try:
        yield
    finally:
        after = ctypes.create_string_buffer(32)
        libm.fegetenv(after)
        libm.fesetenv(before)
    (word,) = WORD.unpack_from(after.raw)
    assert word & 0xE040 == bits, "the caller's environment is brought back"


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call() -> Iterator[None]:
    with environment(FLUSH):
        return (yield)
