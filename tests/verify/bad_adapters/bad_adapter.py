"""An adapter with one misbehaviour: `bad_adapter.py WAY [ARGUMENT]`.

Everything except the named way is right: `right` alone answers with the exact sum. `ways.py` holds
the ways.
"""

from __future__ import annotations

import sys
from typing import Any

from ways import WAYS


def main() -> None:
    way: Any = WAYS[sys.argv[1]]()
    way.argument = sys.argv[2] if len(sys.argv) > 2 else ""
    way.serve()


if __name__ == "__main__":
    main()
