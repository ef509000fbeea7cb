include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS gable_grammar gable_residuals gable_engine EXPORT gableTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
foreach(floor grammar residuals engine)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${floor}
          DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/gable FILES_MATCHING PATTERN "*.h")
endforeach()
if(EXISTS ${PROJECT_SOURCE_DIR}/models)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/models/ DESTINATION ${CMAKE_INSTALL_DATADIR}/gable/models
          FILES_MATCHING PATTERN "*.scales" PATTERN "*.onnx" PATTERN "*.md")
endif()
install(EXPORT gableTargets NAMESPACE gable:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/gable)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/gableConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/gableConfig.cmake
                              INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/gable)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/gableConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/gableConfig.cmake ${PROJECT_BINARY_DIR}/gableConfigVersion.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/gable)
