"""`run_program.py PROGRAM [WORD...]`: runs an adapter in Python, which may import this file's
neighbours."""

import runpy
import sys

sys.argv = sys.argv[1:]
runpy.run_path(sys.argv[0], run_name="__main__")
