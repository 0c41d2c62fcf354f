#!/bin/bash -eu
exec "$SRC/minkref/tests/fuzzing/oss_fuzz/build.sh"
