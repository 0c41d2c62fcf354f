"""Invalid input of every kind, in the plane and in space, is refused with a place and a mend by
every command that reads it, and nothing is written. Repair makes the promised set or solid of
damaged files, lists every change, and makes no other; a repaired file needs no repair."""
