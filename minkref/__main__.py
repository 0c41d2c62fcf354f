"""Makes `python -m minkref` run the command `minkref`."""

from minkref.cli.cli import main

if __name__ == "__main__":
    main()
