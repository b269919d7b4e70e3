# embed(TARGET NAME FILE...): the bytes of the files, one after another, become a part of TARGET:
#   #include "embed/NAME.h"
#   extern const char NAME[SIZE + 1];  their bytes, and a '\0' behind them
#   extern const size_t NAME_size;     how many there are, without that
# NAME carries the prefix of the folder whose library TARGET is. They are made anew when a file changes.
#
# embed_table(TARGET NAME HEADER STRUCT FILE...): each file as above, and a table of them, which HEADER
# declares: const struct STRUCT NAME[], of {path as given, bytes, size}, and how many: const size_t NAME_count.
if(CMAKE_SCRIPT_MODE_FILE) # as a step of the build: NAME, OUT, FILES
  set(hex "")
  foreach(file ${FILES})
    file(READ ${file} bytes HEX)
    string(APPEND hex "${bytes}")
  endforeach()
  string(LENGTH "${hex}" digits)
  math(EXPR size "${digits} / 2")
  string(REGEX REPLACE "(..)" "'\\\\x\\1'," values "${hex}") # as char, whether that has a sign or not
  string(REGEX REPLACE "([^,]+,[^,]+,[^,]+,[^,]+,[^,]+,[^,]+,[^,]+,[^,]+,)" "\\1\n" values "${values}")
  file(WRITE ${OUT}.h "#pragma once\n#include <stddef.h>\nextern const char ${NAME}[${size} + 1];\nextern const size_t ${NAME}_size;\n")
  file(WRITE ${OUT}.c "#include \"embed/${NAME}.h\"\nconst char ${NAME}[] = {\n${values}0};\nconst size_t ${NAME}_size = ${size};\n")
  return()
endif()

set(EMBED_SCRIPT ${CMAKE_CURRENT_LIST_FILE})
function(embed target name)
  set(files "")
  foreach(file ${ARGN})
    get_filename_component(file ${file} ABSOLUTE)
    list(APPEND files ${file})
  endforeach()
  set(out ${PROJECT_BINARY_DIR}/generated/embed/${name})
  add_custom_command(OUTPUT ${out}.c ${out}.h
    COMMAND ${CMAKE_COMMAND} -DNAME=${name} -DOUT=${out} "-DFILES=${files}" -P ${EMBED_SCRIPT}
    DEPENDS ${files} ${EMBED_SCRIPT} COMMENT "Embedding ${name}" VERBATIM)
  target_sources(${target} PRIVATE ${out}.c ${out}.h)
endfunction()

function(embed_table target name header struct)
  set(includes "#include \"${header}\"\n\n")
  set(rows "")
  foreach(file ${ARGN})
    string(MAKE_C_IDENTIFIER ${name}_${file} bytes)
    embed(${target} ${bytes} ${file})
    string(APPEND includes "#include \"embed/${bytes}.h\"\n")
    string(APPEND rows "    {\"${file}\", ${bytes}, sizeof ${bytes} - 1},\n")
  endforeach()
  list(LENGTH ARGN count)
  set(out ${PROJECT_BINARY_DIR}/generated/embed/${name}.c)
  file(CONFIGURE OUTPUT ${out} CONTENT "${includes}
const struct ${struct} ${name}[] = {
${rows}    {0}};
const size_t ${name}_count = ${count};
" @ONLY)
  target_sources(${target} PRIVATE ${out})
endfunction()
