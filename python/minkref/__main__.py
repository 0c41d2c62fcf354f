"""`python -m minkref` is the command `minkref`."""

from minkref.commands.line.cli import main

if __name__ == "__main__":
    main()
