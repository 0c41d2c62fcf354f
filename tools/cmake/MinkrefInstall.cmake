# Installs minkref::reference, its headers, the CMake package and a file for pkg-config.
include_guard(GLOBAL)
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(MINKREF_CMAKE_DIR "${CMAKE_INSTALL_LIBDIR}/cmake/minkref")
set(MINKREF_HEADER_DIR "${CMAKE_INSTALL_INCLUDEDIR}/minkref")

install(TARGETS minkref_reference EXPORT minkrefTargets
        ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT development
        LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT development
        INCLUDES DESTINATION "${MINKREF_HEADER_DIR}")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/reference" DESTINATION "${MINKREF_HEADER_DIR}"
        COMPONENT development FILES_MATCHING PATTERN "*.hpp")
install(EXPORT minkrefTargets NAMESPACE minkref:: DESTINATION "${MINKREF_CMAKE_DIR}"
        COMPONENT development)
configure_package_config_file(
  "${PROJECT_SOURCE_DIR}/tools/cmake/minkrefConfig.cmake.in" "${PROJECT_BINARY_DIR}/minkrefConfig.cmake"
  INSTALL_DESTINATION "${MINKREF_CMAKE_DIR}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/minkrefConfigVersion.cmake"
                                 COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/minkrefConfig.cmake"
              "${PROJECT_BINARY_DIR}/minkrefConfigVersion.cmake"
              "${PROJECT_SOURCE_DIR}/tools/cmake/FindGMP.cmake"
              "${PROJECT_SOURCE_DIR}/tools/cmake/FindMPFR.cmake"
        DESTINATION "${MINKREF_CMAKE_DIR}" COMPONENT development)
# The prefix is told by the place of the file: `cmake --install --prefix` may choose another one.
set(MINKREF_PC_PREFIX "${CMAKE_INSTALL_PREFIX}")
if(NOT IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}")
  file(RELATIVE_PATH MINKREF_PC_PREFIX "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
  string(PREPEND MINKREF_PC_PREFIX "\${pcfiledir}/")
endif()
cmake_path(APPEND MINKREF_PC_LIBDIR "\${prefix}" "${CMAKE_INSTALL_LIBDIR}")
cmake_path(APPEND MINKREF_PC_INCLUDEDIR "\${prefix}" "${MINKREF_HEADER_DIR}")
configure_file("${PROJECT_SOURCE_DIR}/tools/cmake/minkref.pc.in" "${PROJECT_BINARY_DIR}/minkref.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/minkref.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig"
        COMPONENT development)
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}"
        COMPONENT development)
