"""A judge of the events of a disc: places, kinds, features, and what becomes of holes."""

from .boundary import Boundary
from .event import Found, event_faults
from .history import history_faults

__all__ = ["Boundary", "Found", "event_faults", "history_faults"]
