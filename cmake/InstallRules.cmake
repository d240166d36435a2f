# cmake --install gives the command, the libraries, the headers, the data files and find_package(scanchor).
include(CMakePackageConfigHelpers)
get_property(rooms GLOBAL PROPERTY SCANCHOR_ROOMS)
set(targets)
foreach(room IN LISTS rooms)
  list(APPEND targets scanchor_${room})
  install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/${room}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/scanchor/${room}
          FILES_MATCHING PATTERN "*.hpp" PATTERN "node_modules" EXCLUDE)
endforeach()
install(TARGETS ${targets} scanchor_bullet scanchor_embree scanchor_cgal scanchor_nanoflann scanchor_opencv scanchor_gl
        EXPORT scanchor_targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
if(TARGET scanchor)
  install(TARGETS scanchor RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
foreach(folder ontologies suites protocols)
  if(IS_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/${folder})
    install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/${folder} DESTINATION ${CMAKE_INSTALL_DATADIR}/scanchor)
  endif()
endforeach()
install(FILES results/report/bundle.js results/report/style.css results/report/LICENSES.txt
        DESTINATION ${CMAKE_INSTALL_DATADIR}/scanchor/results/report)
install(FILES results/font/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/scanchor/results/font)
install(EXPORT scanchor_targets NAMESPACE scanchor:: FILE scanchorTargets.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/scanchor)
configure_package_config_file(cmake/scanchorConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/scanchorConfig.cmake
        INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/scanchor)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/scanchorConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/scanchorConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/scanchorConfigVersion.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/scanchor)
