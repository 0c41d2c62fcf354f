"""What a case may ask for in place of the verb `at` of the adapter protocol: LAW(NAME) with one of
the verbs for the law, or operands of which one is invalid."""

UPDATE, EVENTS = "update", "events"
REJECTS = "rejects-invalid"  # the capability that invalid cases ask for
