"""`python adapter.py NAME`: the adapter of this name, right or faulty."""

from __future__ import annotations

import sys

from catalogue import ADAPTERS

if __name__ == "__main__":
    ADAPTERS[sys.argv[1]]().serve()
