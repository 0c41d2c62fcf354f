"""The judge of what leaves the program: own readers of every format, own numbers of 1,500 bits."""
