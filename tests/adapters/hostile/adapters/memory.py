"""Adapters that take more memory than allowed, from every kind of memory."""

from __future__ import annotations

import ctypes
import mmap
import os
import time

from bounds import GIGABYTE, fork
from honest import Adapter, Request
from processes import linger, without_pipes

LIBC = ctypes.CDLL(None, use_errno=True)
MEGABYTE = 1 << 20


class EatsMemory(Adapter):
    """Two and a half gigabytes in one process."""

    instead = "at"

    def mischief(self, request: Request) -> None:
        self.eaten = []
        for _ in range(2560):
            self.eaten.append(b"x" * MEGABYTE)
        linger()


class EatsMemoryAsATree(Adapter):
    """Ten children of 250 megabytes each."""

    instead = "at"

    def mischief(self, request: Request) -> None:
        for _ in range(10):
            if fork() == 0:
                self.get_away()
                without_pipes()
                self.eaten = b"x" * (250 * MEGABYTE)
                linger()
        time.sleep(20)
        os._exit(0)

    def get_away(self) -> None:
        pass


class EatsMemoryOfDaemons(EatsMemoryAsATree):
    """Ten daemons of 250 megabytes each, in separate sessions."""

    def get_away(self) -> None:
        os.setsid()
        if fork():
            os._exit(0)


class EatsSharedMemory(Adapter):
    """Two gigabytes that belong to no process alone."""

    instead = "at"

    def mischief(self, request: Request) -> None:
        with mmap.mmap(-1, 2 * GIGABYTE) as shared:
            for at in range(0, 2 * GIGABYTE, mmap.PAGESIZE):
                shared[at] = 1
            linger()


class EatsUnmappedMemory(Adapter):
    """Unmapped files in memory."""

    instead = "at"

    def mischief(self, request: Request) -> None:
        block = b"x" * MEGABYTE
        for k in range(2):
            number = os.memfd_create(f"minkref-hostile-{k}")
            for _ in range(1023):
                os.write(number, block)
        linger()


class OpensFiles(Adapter):
    """As many open files as it can have."""

    instead = "at"

    def mischief(self, request: Request) -> None:
        try:
            while True:
                os.open(os.devnull, os.O_RDONLY)
        except OSError:
            linger()
