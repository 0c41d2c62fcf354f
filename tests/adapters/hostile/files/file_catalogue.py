"""All hostile files."""

from __future__ import annotations

import places
import plane_files
import settings_files
import space_files
from hostile_file import Hostile
from made_files import certificates, indices, ledgers

FILES: list[Hostile] = [
    *plane_files.FILES,
    *space_files.FILES,
    *indices(),
    *certificates(),
    *ledgers(),
    *settings_files.FILES,
    *places.FILES,
]
