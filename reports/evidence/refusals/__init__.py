"""Invalid input of every kind, in the plane and in space, is refused with a place and a mend by
every command that reads it, and nothing is written."""
