# The settings with which every target of ours is compiled.
include_guard(GLOBAL)

if(PROJECT_IS_TOP_LEVEL)
  if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
  endif()
  # No NDEBUG: Eigen and Boost keep their assertions. Ours are exceptions, in every build of anybody.
  set(CMAKE_CXX_FLAGS_RELEASE "-O2")
  find_program(CCACHE_PROGRAM ccache)
  if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    # By overlooking the following, the cache works with a precompiled header.
    set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND}" -E env
        "CCACHE_SLOPPINESS=pch_defines,time_macros"
        # Paths in the checkout count as relative ones. (Grouped sources hold absolute paths: another clone
        # compiles these anew.)
        "CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}" "CCACHE_NOHASHDIR=1" "${CCACHE_PROGRAM}")
  endif()
endif()

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
# One compilation of the library serves executables and the extension module.
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

# The error bounds of the float filters are stated for IEEE operations in the order written. (They hold
# with contraction too, for those who compile our headers with it: reference/paper/trials/float_trial.hpp.)
add_compile_options(-ffp-contract=off)

# minkref_precompiled(TARGET HEADER...): a precompiled header of these and tools/cmake/precompiled.hpp.
# minkref_precompiled(TARGET AS OTHER): that of another target, compiled with the same flags.
function(minkref_precompiled target)
  if(NOT MINKREF_PCH)
    return()
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -fpch-preprocess)  # for ccache
  elseif(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    target_compile_options(${target} PRIVATE "SHELL:-Xclang -fno-pch-timestamp")
  endif()
  if(ARGV1 STREQUAL "AS")
    target_precompile_headers(${target} REUSE_FROM ${ARGV2})
  else()
    target_precompile_headers(${target} PRIVATE "${PROJECT_SOURCE_DIR}/tools/cmake/precompiled.hpp" ${ARGN})
  endif()
endfunction()

# minkref_unity(TARGET...): sources are compiled some at a time, since headers take longest. Each is still
# a file of its own: MINKREF_UNITY=OFF (and every build by clang for the fuzzers) compiles one by one.
function(minkref_unity)
  if(NOT MINKREF_UNITY)
    return()
  endif()
  foreach(target IN LISTS ARGN)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 6)
    # A name of one source may hide that of another, and types of an unnamed namespace stand in a class.
    target_compile_options(${target} PRIVATE -Wno-shadow)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
    endif()
  endforeach()
endfunction()

# minkref_warnings(TARGET...): warnings are errors in our own code. Headers of others come in through
# imported targets, which are system headers and do not warn.
function(minkref_warnings)
  foreach(target IN LISTS ARGN)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
      # GCC 12 sees an overlap in `"text" + string` where there is none (GCC bug 105651), and more limbs
      # in a fixed-width integer of Boost than it has room for.
      target_compile_options(${target} PRIVATE -Wno-restrict -Wno-array-bounds
                             -Wno-stringop-overread -Wno-stringop-overflow)
    endif()
    if(MINKREF_WERROR)
      target_compile_options(${target} PRIVATE -Werror)
    endif()
  endforeach()
endfunction()
