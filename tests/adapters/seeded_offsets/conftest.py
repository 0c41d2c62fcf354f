"""The modules of this folder by their bare names, as a target `py:seeded_sums:NAME` has them."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
