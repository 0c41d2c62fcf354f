"""The rules of `--rule`."""

RULES = ("nonzero", "evenodd", "positive")
