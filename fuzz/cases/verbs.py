"""Requests of a case in place of the verb `at` of the adapter protocol: LAW(NAME) with one of the
verbs for the law, a path, or operands of which one is invalid."""

UPDATE, EVENTS = "update", "events"
PATH, RANGES = "path", "path-ranges"  # the verb `path`: single scales, or all of a window
REJECTS = "rejects-invalid"  # the capability that invalid cases ask for


def is_path(text: str) -> bool:
    """Whether the text that names a case is one of a path itself."""
    return text.startswith('{"part"')
