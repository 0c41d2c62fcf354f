"""The wall of findings holds: each witness is confirmed in fractions, and each program whose
library is installed still shows its fault."""
