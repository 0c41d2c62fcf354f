"""`python adapter.py NAME [WORD=VALUE ...]`: the hostile adapter of this name."""

from __future__ import annotations

import sys

from bounds import bind
from catalogue import ADAPTERS

if __name__ == "__main__":
    bind()
    told = dict(word.split("=", 1) for word in sys.argv[2:])
    ADAPTERS[sys.argv[1]](told).serve()
