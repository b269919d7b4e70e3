# Writes revision.h, and touches it only when the revision has changed.
cmake_minimum_required(VERSION 3.22)
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=12
                OUTPUT_VARIABLE rev OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT rev)
  set(rev "unknown")
endif()
file(CONFIGURE OUTPUT ${OUT} CONTENT
"#pragma once
#define PLUNGE_VERSION \"@VERSION@\"
#define PLUNGE_REVISION \"@rev@\"
" @ONLY)
