# Installs the Python package, component `python`: the extension module, and the rooms that pyproject.toml names. Inside a wheel
# scikit-build-core copies the rooms itself. Started by `python -m minkref`; the package's dependencies are not installed.
include_guard(GLOBAL)
set(MINKREF_PYTHON_DEFAULT minkref)
if(NOT SKBUILD)
  # Where Python_EXECUTABLE looks for modules below its own prefix, as lib/python3.11/site-packages.
  execute_process(
    COMMAND "${Python_EXECUTABLE}" -c
            "import os, sysconfig as s; print(os.path.relpath(s.get_path('platlib'), s.get_config_var('platbase')))"
    OUTPUT_VARIABLE MINKREF_PYTHON_DEFAULT OUTPUT_STRIP_TRAILING_WHITESPACE
    COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX REPLACE "^local/" "" MINKREF_PYTHON_DEFAULT "${MINKREF_PYTHON_DEFAULT}")  # Debian's
  string(APPEND MINKREF_PYTHON_DEFAULT "/minkref")
endif()
set(MINKREF_PYTHON_DIR "${MINKREF_PYTHON_DEFAULT}" CACHE PATH
    "folder of the package minkref, absolute or below the prefix of the installation")

install(TARGETS _core LIBRARY DESTINATION "${MINKREF_PYTHON_DIR}" COMPONENT python)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/_core.pyi" DESTINATION "${MINKREF_PYTHON_DIR}"
        COMPONENT python)
if(NOT SKBUILD)
  file(STRINGS "${PROJECT_SOURCE_DIR}/pyproject.toml" rooms REGEX "^\"minkref[a-z/]*\" = \"")
  foreach(line IN LISTS rooms)
    string(REGEX MATCH "^\"minkref/?([a-z/]*)\" = \"([a-z/]+)\"$" line "${line}")
    install(DIRECTORY "${PROJECT_SOURCE_DIR}/${CMAKE_MATCH_2}/"
            DESTINATION "${MINKREF_PYTHON_DIR}/${CMAKE_MATCH_1}" COMPONENT python
            PATTERN "__pycache__" EXCLUDE PATTERN "CMakeLists.txt" EXCLUDE
            REGEX "/minkref/(certify|degeneracies|fuzz|reports|oracle|_core[^/]*)$" EXCLUDE  # links
            REGEX "/(certify|checker)/([a-z]+/)?[a-z_0-9]+\\.[ch]pp$" EXCLUDE)
  endforeach()
endif()
