#!/bin/bash
# try.sh wheels|container|vcpkg|conan: makes a package as a release has it, and uses it. All of them fetch what they need: the
# wheels images by docker, vcpkg (in VCPKG_ROOT) and Conan the sources of what minkref depends on.
set -euo pipefail
cd "$(dirname "$0")/../.."

tools() {
  python3 -m venv build/tools
  build/tools/bin/python -m pip install --quiet --require-hashes --only-binary :all: -r tools/packaging/tools.requirements.txt
}

case ${1:-} in
  wheels)
    tools
    build/tools/bin/cibuildwheel --platform linux --output-dir dist
    build/tools/bin/python tools/packaging/bare.py dist/minkref-*-cp312-abi3-*.whl  # on a machine without compiler and GMP
    ;;
  container)
    engine=$(command -v podman || command -v docker)
    "$engine" build -f Containerfile -t minkref .
    "$engine" run --rm minkref sum g1 g2 --scale 7/5
    "$engine" run --rm minkref targets
    ;;
  vcpkg)
    root=${VCPKG_ROOT:-${VCPKG_INSTALLATION_ROOT:?no vcpkg: set VCPKG_ROOT}}
    "$root/vcpkg" install minkref --classic --overlay-ports=tools/packaging/vcpkg
    cmake -S tests/consumer -B build/consumer-vcpkg -DCMAKE_TOOLCHAIN_FILE="$root/scripts/buildsystems/vcpkg.cmake"
    cmake --build build/consumer-vcpkg
    build/consumer-vcpkg/consumer
    ;;
  conan)
    tools
    build/tools/bin/conan profile detect --exist-ok
    build/tools/bin/conan create tools/packaging/conan --build=missing  # with its test package
    ;;
  *)
    sed -n 's/^# //p' "$0" >&2
    exit 2
    ;;
esac
