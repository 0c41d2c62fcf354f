"""`python3 -m slow`, or `python3 -m minkref.oracle.slow` where the folder is linked into the
package."""

import sys

from .command import main

if __name__ == "__main__":
    sys.exit(main())
