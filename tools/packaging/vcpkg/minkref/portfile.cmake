# An overlay port: vcpkg install minkref --overlay-ports=tools/packaging/vcpkg
# It builds the checkout that it stands in. A port for others' registries takes vcpkg_from_git with a tag instead.
set(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../../..")
set(VCPKG_BUILD_TYPE release)  # a static library, whose invariants throw in every build

vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS
    -DMINKREF_FORMATS=OFF
    -DMINKREF_CGAL=OFF
    -DMINKREF_CHECKER=OFF
    -DMINKREF_SAMPLED=OFF
    -DMINKREF_BOOST=OFF
    -DMINKREF_TESTS=OFF
    -DMINKREF_PCH=OFF
    -DMINKREF_WERROR=OFF
)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/minkref)
vcpkg_fixup_pkgconfig()
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
file(INSTALL "${CMAKE_CURRENT_LIST_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")
