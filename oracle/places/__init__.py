"""A judge for a disc's events: places, kinds, features, and the history of holes."""

from .boundary import Boundary
from .event import Found, event_faults
from .history import history_faults

__all__ = ["Boundary", "Found", "event_faults", "history_faults"]
