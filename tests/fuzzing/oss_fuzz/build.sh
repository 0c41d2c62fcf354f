#!/bin/bash -eu
# Builds the fuzz targets as OSS-Fuzz and ClusterFuzzLite ask: with CC, CXX, CFLAGS, CXXFLAGS and LIB_FUZZING_ENGINE of
# their images, from $SRC/minkref, into $OUT; $WORK is for what comes between. MINKREF_FUZZ_TARGETS names some targets;
# MINKREF_REFERENCE_ARCHIVE a built reference, which saves half an hour and is not instrumented.
cd "$SRC/minkref"
build="${WORK:-/tmp}/minkref-fuzzing"
read -ra targets <<<"${MINKREF_FUZZ_TARGETS:-}"
more=(-DMINKREF_FUZZ_REFERENCE=ON)
[ -z "${MINKREF_REFERENCE_ARCHIVE:-}" ] ||
  more=(-DMINKREF_FUZZ_REFERENCE=OFF "-DMINKREF_REFERENCE_ARCHIVE=$MINKREF_REFERENCE_ARCHIVE")
# The images that run the targets have neither GMP nor MPFR: both are linked in.
for library in gmp mpfr; do
  archive="$(find /usr/lib /usr/local/lib -name "lib$library.a" -print -quit)"
  [ -z "$archive" ] || more+=("-D${library^^}_LIBRARIES=$archive")
done

cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=None -DMINKREF_FUZZ=ON -DMINKREF_FUZZ_ENGINE="$LIB_FUZZING_ENGINE" \
  -DMINKREF_CGAL=OFF -DMINKREF_CHECKER=OFF -DMINKREF_SAMPLED=OFF -DMINKREF_BOOST=OFF -DMINKREF_PYTHON=OFF \
  -DMINKREF_TESTS=OFF -DMINKREF_INSTALL=OFF "${more[@]}"
cmake --build "$build" -j "${MINKREF_JOBS:-$(nproc)}" --target "${targets[@]:-all}"

# The seeds of a target, by its name; those on the plane's sums and on bodies share theirs.
seeds_of() {
  case "$1" in
    fuzz_convex*) echo bodies ;;
    fuzz_sum | fuzz_dynamic | fuzz_events | fuzz_passages | fuzz_scene) echo pair ;;
    *) echo "${1#fuzz_}" ;;
  esac
}

find "$build/tests/fuzzing" -maxdepth 2 -type f -name 'fuzz_*' -executable | sort | while read -r path; do
  target="$(basename "$path")"
  if [ "${#targets[@]}" -gt 0 ] && [[ " ${targets[*]} " != *" $target "* ]]; then continue; fi
  seeds="$(seeds_of "$target")"
  cp "$path" "$OUT/"
  python3 - "tests/fuzzing/corpus/$seeds" "$OUT/${target}_seed_corpus.zip" <<'PYTHON'
import sys
import zipfile
from pathlib import Path

with zipfile.ZipFile(sys.argv[2], "w", zipfile.ZIP_DEFLATED) as seeds:
    for path in sorted(Path(sys.argv[1]).iterdir()):
        seeds.writestr(zipfile.ZipInfo(path.name), path.read_bytes())
PYTHON
  dictionary="tests/fuzzing/oss_fuzz/dictionaries/$seeds.dict"
  { [ ! -f "$dictionary" ] || cp "$dictionary" "$OUT/$target.dict"; }
  case "$seeds" in
    pair) most=8192 ;;
    bodies) most=256 ;;
    *) most=4096 ;;
  esac
  printf '[libfuzzer]\nmax_len = %s\ntimeout = 60\nrss_limit_mb = 2500\n' "$most" >"$OUT/$target.options"
  if [ "$seeds" = pair ]; then printf 'len_control = 0\nentropic = 0\ndetect_leaks = 0\n' >>"$OUT/$target.options"; fi
done
