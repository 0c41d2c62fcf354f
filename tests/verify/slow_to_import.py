"""A module whose import takes longer than a call may."""

import time

from faulty_sums import right as right

time.sleep(1.5)
