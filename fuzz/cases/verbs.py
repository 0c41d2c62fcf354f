"""Verbs of the adapter protocol that a case may ask for in place of `at`: LAW(NAME) with one of
them for the law."""

UPDATE, EVENTS = "update", "events"
