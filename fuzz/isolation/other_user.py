"""A separate user for a foreign program, if we are root.

The user can read our files, so that the program starts anywhere, but can neither signal our
processes nor write our files.
"""

from __future__ import annotations

import ctypes
import os
import secrets
import struct

FIRST, COUNT = 61184, 4336  # the range that systemd keeps for users that come and go
CAP_DAC_READ_SEARCH = 2
CAPABILITY_VERSION = 0x20080522
PR_SET_KEEPCAPS, PR_SET_NO_NEW_PRIVS, PR_CAP_AMBIENT, PR_CAP_AMBIENT_RAISE = 8, 38, 47, 2


def a_user() -> int:
    return FIRST + secrets.randbelow(COUNT)


def can_change() -> bool:
    """Whether a child of ours can become another user and still read as we do."""
    if os.geteuid() != 0:
        return False
    child = os.fork()
    if child == 0:
        try:
            become(a_user())
            os._exit(0)
        finally:
            os._exit(1)
    return os.waitpid(child, 0)[1] == 0


def become(user: int) -> None:
    """Changes to the user, in a child process. Raises OSError if the system does not allow this."""
    libc = ctypes.CDLL(None, use_errno=True)
    os.setgroups([])
    _call(libc.prctl, PR_SET_KEEPCAPS, 1, 0, 0, 0)
    os.setresgid(user, user, user)
    os.setresuid(user, user, user)
    bit = 1 << CAP_DAC_READ_SEARCH
    head = struct.pack("=Ii", CAPABILITY_VERSION, 0)
    _call(libc.capset, head, struct.pack("=6I", bit, bit, bit, 0, 0, 0))
    _call(libc.prctl, PR_CAP_AMBIENT, PR_CAP_AMBIENT_RAISE, CAP_DAC_READ_SEARCH, 0, 0)


def forbid_new_privileges() -> None:
    """Stops programs that change the user (sudo) from doing so, here and in child processes."""
    ctypes.CDLL(None).prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0)


def _call(function: object, *arguments: object) -> None:
    if function(*arguments) != 0:  # type: ignore[operator]
        number = ctypes.get_errno()
        raise OSError(number, os.strerror(number))
