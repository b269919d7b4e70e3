# SuiteSparse 5 ships no CMake files in Debian 12 and Ubuntu 24.04.
find_path(SuiteSparse_INCLUDE cholmod.h PATH_SUFFIXES suitesparse)
find_library(SuiteSparse_CHOLMOD cholmod)
find_library(SuiteSparse_AMD amd)
find_library(SuiteSparse_CONFIG suitesparseconfig)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(SuiteSparse REQUIRED_VARS SuiteSparse_CHOLMOD SuiteSparse_INCLUDE)
if(SuiteSparse_FOUND AND NOT TARGET SuiteSparse::cholmod)
  add_library(SuiteSparse::cholmod UNKNOWN IMPORTED)
  set_target_properties(SuiteSparse::cholmod PROPERTIES
    IMPORTED_LOCATION ${SuiteSparse_CHOLMOD}
    INTERFACE_INCLUDE_DIRECTORIES ${SuiteSparse_INCLUDE}
    INTERFACE_LINK_LIBRARIES "${SuiteSparse_AMD};${SuiteSparse_CONFIG}")
endif()
