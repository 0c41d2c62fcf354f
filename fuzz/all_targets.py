"""All targets of this project: the commands hand them to a run and to its workers."""

from __future__ import annotations

from minkref.fuzz.judges import checks
from minkref.fuzz.libraries import offer as libraries
from minkref.fuzz.run.catalogue import Catalogue

ALL_TARGETS = Catalogue(checks.OFFER, libraries.OFFER)
