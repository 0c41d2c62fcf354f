"""Requests that replace the verb `at` of the adapter protocol: LAW(NAME) with a verb for the law, a
path, sets to unite, a set to grow, features of a set, or operands with one invalid."""

UPDATE, EVENTS = "update", "events"
PAIR_EVENTS = "pair-events"  # of edges of the reduced convolution
PATH, RANGES = "path", "path-ranges"  # the verb `path`: single scales, or all of a window
UNION = "union"  # of two or more sets
OFFSET = "offset"  # a set grown by a disc
LINES = "line-offset"  # the capability that open lines ask for
SHARP_OFFSET, SHARP_INSET = "join-sharp", "inset-sharp"  # capabilities beside `offset`
INSET = "inset"  # the capability that a radius below 0 asks for
FEATURES = "features"  # of a set, under a growing disc
REJECTS = "rejects-invalid"  # the capability that invalid cases ask for


def is_path(text: str) -> bool:
    """Whether a case's text names a path itself."""
    return text.startswith('{"part"')


def is_union(text: str) -> bool:
    """Whether a case's text names sets to unite themselves."""
    return text.startswith('{"sets"')


def is_offset(text: str) -> bool:
    """Whether a case's text names a set to grow itself."""
    return text.startswith('{"offset"')


def is_features(text: str) -> bool:
    """Whether a case's text names a set itself whose features are asked for."""
    return text.startswith('{"features"')
