"""minkref: the exact reference for Minkowski sums under scaling (Behar & Lien 2012)."""

from minkref.version import version

__version__ = version()
