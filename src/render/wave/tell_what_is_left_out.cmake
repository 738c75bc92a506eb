# tell_what_is_left_out(FILE HOME): gives FILE, of the rows of stage.def that name HOME, the definition
# ALHAZEN_LEFT_OUT_HERE (left_out_here.h): those effects of ALHAZEN_LEAVE_OUT that its rows or its own
# text name, or the wholes of which these are parts. A row is two lines.
file(READ stage.def stage_rows)
set(effect_part_def ${PROJECT_SOURCE_DIR}/src/core/scene/effect_part.def)
file(STRINGS ${effect_part_def} effect_parts REGEX "^ALHAZEN_EFFECT_PART")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS stage.def ${effect_part_def})

function(tell_what_is_left_out file home)
  string(REGEX MATCHALL "ALHAZEN_STAGE\\([a-z_]+, [a-z]+, ${home},[^\n]*\n[^\n]*" rows
    "${stage_rows}")
  if(NOT rows)
    message(FATAL_ERROR "stage.def has no row for ${home}, of ${file}")
  endif()
  file(READ ${file} text)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  string(REGEX MATCHALL "(has\\(|Effect::)[a-z_]+" concerned "${rows}${text}")
  list(TRANSFORM concerned REPLACE "has\\(|Effect::" "")
  foreach(row ${effect_parts})
    if(row MATCHES "\\(([a-z_]+), ([a-z_]+)\\)" AND CMAKE_MATCH_1 IN_LIST concerned)
      list(APPEND concerned ${CMAKE_MATCH_2})
    endif()
  endforeach()
  set(here "")
  foreach(effect ${ALHAZEN_LEAVE_OUT})
    if(effect IN_LIST concerned)
      list(APPEND here ${effect})
    endif()
  endforeach()
  list(JOIN here "," here)
  set_source_files_properties(${file} PROPERTIES
    COMPILE_DEFINITIONS "ALHAZEN_LEFT_OUT_HERE=\"${here}\"")
endfunction()
