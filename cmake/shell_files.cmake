# Man pages (scdoc) and completions, made while building and installed beside the programs.

include(GNUInstallDirs)

find_program(RAD_SCDOC scdoc)
find_program(RAD_GZIP gzip)
if(RAD_SCDOC AND RAD_GZIP)
  foreach(page radlint.1 radfix.1 radlint.toml.5)
    set(source ${PROJECT_SOURCE_DIR}/docs/man/${page}.scd)
    set(made ${PROJECT_BINARY_DIR}/man/${page}.gz)
    add_custom_command(OUTPUT ${made} DEPENDS ${source} VERBATIM
                       COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/man
                       COMMAND ${CMAKE_COMMAND} -E env SOURCE_DATE_EPOCH=0 sh -c
                               "'${RAD_SCDOC}' < '${source}' | '${RAD_GZIP}' -9n > '${made}'")
    list(APPEND man_pages ${made})
    string(REGEX REPLACE ".*\\." "" chapter ${page})
    install(FILES ${made} DESTINATION ${CMAKE_INSTALL_MANDIR}/man${chapter} OPTIONAL)
  endforeach()
  add_custom_target(rad_man ALL DEPENDS ${man_pages})
else()
  message(STATUS "scdoc was not found: no man pages")
endif()

foreach(program radlint radfix)
  set(bash_file ${PROJECT_BINARY_DIR}/completion/bash/${program})
  set(zsh_file ${PROJECT_BINARY_DIR}/completion/zsh/_${program})
  set(fish_file ${PROJECT_BINARY_DIR}/completion/fish/${program}.fish)
  foreach(shell bash zsh fish)
    get_filename_component(folder ${${shell}_file} DIRECTORY)
    file(MAKE_DIRECTORY ${folder})
    add_custom_command(OUTPUT ${${shell}_file} DEPENDS ${program} VERBATIM
                       COMMAND ${program} --completion ${shell} > ${${shell}_file})
    list(APPEND completions ${${shell}_file})
  endforeach()
  install(FILES ${bash_file} DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions OPTIONAL)
  install(FILES ${zsh_file} DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions OPTIONAL)
  install(FILES ${fish_file} DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d OPTIONAL)
endforeach()
add_custom_target(rad_completions ALL DEPENDS ${completions})
