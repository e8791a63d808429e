# The layers of the project and the one way to add a library to them.
#
# RAD_LAYERS_<target> lists what a layer may link; rad_library() stops the configure step on any other edge, and
# tools/check_includes.py holds every #include against the same table.

set(RAD_ALLOWED_geom "")
set(RAD_ALLOWED_scene geom)
set(RAD_ALLOWED_readers scene geom)
set(RAD_ALLOWED_writers scene geom)
set(RAD_ALLOWED_validate scene geom)
set(RAD_ALLOWED_repair validate scene geom)
set(RAD_ALLOWED_mesh scene geom)
set(RAD_ALLOWED_solve mesh scene geom)
set(RAD_ALLOWED_bake mesh scene geom)
set(RAD_ALLOWED_report bake validate mesh scene geom)
set(RAD_ALLOWED_corpus repair writers readers validate scene geom)
set(RAD_ALLOWED_config report validate scene geom)
set(RAD_ALLOWED_batch readers writers scene geom)
set(RAD_ALLOWED_cli batch config report bake solve mesh repair readers writers validate scene geom)

# rad_library(<folder> [SOURCES <file>...] [USES <layer>...] [PUBLIC <target>...] [PRIVATE <target>...])
#   Makes rad_<folder> (alias rad::<folder>) of every .cpp of the folder (or of SOURCES). USES are layers of this
#   project; PUBLIC and PRIVATE are third-party targets.
function(rad_library layer)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES;PUBLIC;PRIVATE" ${ARGN})
  foreach(used IN LISTS ARG_USES)
    if(NOT used IN_LIST RAD_ALLOWED_${layer})
      message(FATAL_ERROR "layer '${layer}' may not use '${used}': see cmake/layers.cmake")
    endif()
  endforeach()
  if(NOT ARG_SOURCES)
    file(GLOB_RECURSE ARG_SOURCES CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
    list(FILTER ARG_SOURCES EXCLUDE REGEX "_main\\.cpp$")
  endif()
  add_library(rad_${layer} ${ARG_SOURCES})
  add_library(rad::${layer} ALIAS rad_${layer})
  set_target_properties(rad_${layer} PROPERTIES EXPORT_NAME ${layer})
  target_include_directories(rad_${layer} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
  list(TRANSFORM ARG_USES PREPEND rad::)
  target_link_libraries(rad_${layer} PUBLIC ${ARG_USES} ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE} rad_build_flags)
endfunction()
