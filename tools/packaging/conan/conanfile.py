"""The C++ library as a Conan package: `conan create tools/packaging/conan --build=missing`.

With `-o minkref/*:system=True` the system provides GMP, MPFR, Boost and Eigen.
"""

from pathlib import Path

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load

ROOT = Path(__file__).resolve().parents[3]
SOURCES = ("CMakeLists.txt", "pyproject.toml", "LICENSE", "tools/cmake/*", "reference/*")
PARTS = ("FORMATS", "CGAL", "CHECKER", "SAMPLED", "BOOST", "TESTS", "PCH", "WERROR")


class Minkref(ConanFile):
    name = "minkref"
    license = "Apache-2.0"
    description = "Exact Minkowski sums of polygon sets and convex polyhedra under scaling"
    package_type = "static-library"
    settings = "os", "compiler", "build_type", "arch"
    options = {"system": [True, False]}  # noqa: RUF012 (as Conan has it)
    default_options = {"system": False}  # noqa: RUF012

    def set_version(self):
        lines = load(self, ROOT / "pyproject.toml").splitlines()
        (line,) = (line for line in lines if line.startswith("version = "))
        self.version = line.split('"')[1]

    def export_sources(self):
        for pattern in SOURCES:
            copy(self, pattern, ROOT, self.export_sources_folder)

    def requirements(self):
        if not self.options.system:
            for name in ("gmp/6.3.0", "mpfr/4.2.1", "boost/1.86.0", "eigen/3.4.0"):
                self.requires(name, transitive_headers=True, transitive_libs=True)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        toolchain = CMakeToolchain(self)
        for part in PARTS:
            toolchain.cache_variables[f"MINKREF_{part}"] = False
        toolchain.generate()
        dependencies = CMakeDeps(self)
        for name, target in (("gmp", "GMP"), ("mpfr", "MPFR")):
            dependencies.set_property(name, "cmake_file_name", target)
            dependencies.set_property(name, "cmake_target_name", f"{target}::{target}")
        dependencies.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()

    def package_info(self):
        self.cpp_info.set_property("cmake_find_mode", "none")  # minkref installs its own files
        self.cpp_info.builddirs = ["lib/cmake/minkref"]
