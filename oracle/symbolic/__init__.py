"""Event scales from the definitions, by computer algebra. README.md in this folder tells how."""

from .moving import MovingSegment, s_edge, t_edge
from .pairs import ContradictionError, Event, Interval, contact_set, pair_events
from .parallels import parallel_events
from .rational import Rational, rational
from .solutions import SolutionsError
from .triples import meeting_scales, triple_events

__all__ = [
    "ContradictionError",
    "Event",
    "Interval",
    "MovingSegment",
    "Rational",
    "SolutionsError",
    "contact_set",
    "meeting_scales",
    "pair_events",
    "parallel_events",
    "rational",
    "s_edge",
    "t_edge",
    "triple_events",
]
