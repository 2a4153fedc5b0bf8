# What `cmake --install` puts where. Two components: `gonogo` is the program and all that a vendor
# needs to certify; `oracle` is the libraries and headers to build on.
include(CMakePackageConfigHelpers)
set(config_folder lib/cmake/gonogo)

# The program, its corpus, the C header, the helpers.
install(TARGETS gonogo EXPORT gonogo-program RUNTIME DESTINATION bin COMPONENT gonogo)
set_target_properties(gonogo_subject_abi PROPERTIES EXPORT_NAME subject)
install(TARGETS gonogo_subject_abi EXPORT gonogo-program)
install(FILES include/gonogo/subject.h DESTINATION include/gonogo COMPONENT gonogo)
install(FILES corpus/manifest.json corpus/README.md corpus/LICENSE
  DESTINATION share/gonogo/corpus COMPONENT gonogo)
install(DIRECTORY corpus/vectors corpus/schema DESTINATION share/gonogo/corpus COMPONENT gonogo)
install(PROGRAMS helpers/gonogo_replay.py helpers/gonogo_replay.mjs
  DESTINATION share/gonogo/helpers COMPONENT gonogo)
install(FILES helpers/README.md helpers/gonogo_pipe.py helpers/gonogo_pipe.mjs
  DESTINATION share/gonogo/helpers COMPONENT gonogo)
install(DIRECTORY fuzz/cluster DESTINATION share/gonogo COMPONENT gonogo USE_SOURCE_PERMISSIONS)
install(DIRECTORY helpers/adapters DESTINATION share/gonogo/helpers COMPONENT gonogo
  PATTERN node_modules EXCLUDE PATTERN __pycache__ EXCLUDE)

# Documents, examples, licences.
install(FILES README.md CHANGELOG.md LICENSE cmake/package/copyright
  DESTINATION share/doc/gonogo COMPONENT gonogo)
install(FILES packaging/README.md DESTINATION share/doc/gonogo/packaging COMPONENT gonogo)
install(FILES corpus/LICENSE DESTINATION share/doc/gonogo RENAME LICENSE.corpus COMPONENT gonogo)
install(DIRECTORY docs DESTINATION share/doc/gonogo COMPONENT gonogo PATTERN node_modules EXCLUDE)
install(DIRECTORY examples DESTINATION share/doc/gonogo COMPONENT gonogo
  USE_SOURCE_PERMISSIONS PATTERN __pycache__ EXCLUDE PATTERN build EXCLUDE)

# The oracle: every static library from grammar to what is published under its own name, and
# gonogo::oracle for all of them.
get_property(folders GLOBAL PROPERTY GONOGO_ORACLE_FOLDERS)
list(TRANSFORM folders PREPEND gonogo_ OUTPUT_VARIABLE libraries)
foreach(folder IN LISTS folders)
  set_target_properties(gonogo_${folder} PROPERTIES EXPORT_NAME ${folder})
endforeach()
add_library(gonogo_oracle INTERFACE)
add_library(gonogo::oracle ALIAS gonogo_oracle)
# simdjson changes its layouts with its own definitions: whoever includes it needs the same.
target_link_libraries(gonogo_oracle INTERFACE ${libraries} simdjson::simdjson)
target_compile_features(gonogo_oracle INTERFACE cxx_std_20)
set_target_properties(gonogo_oracle PROPERTIES EXPORT_NAME oracle)
install(TARGETS gonogo_oracle ${libraries}
  gonogo_external_gmp gonogo_external_gmpxx gonogo_external_mpfr gonogo_external_nettle gonogo_external_z
  EXPORT gonogo-oracle ARCHIVE DESTINATION lib/gonogo COMPONENT oracle)
install(DIRECTORY grammar reference oracle subjects campaign capture publish
  DESTINATION include/gonogo-oracle COMPONENT oracle
  FILES_MATCHING PATTERN "*.hpp" PATTERN "*.def" PATTERN x3 EXCLUDE PATTERN assets EXCLUDE)
install(DIRECTORY corpus/io DESTINATION include/gonogo-oracle/corpus COMPONENT oracle FILES_MATCHING PATTERN "*.hpp")

# find_package(gonogo)
configure_package_config_file(cmake/package/gonogo-config.cmake.in
  ${CMAKE_BINARY_DIR}/package/gonogo-config.cmake
  INSTALL_DESTINATION ${config_folder} NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/package/gonogo-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/package/gonogo-config.cmake
  ${CMAKE_BINARY_DIR}/package/gonogo-config-version.cmake cmake/package/gonogo-conformance.cmake
  DESTINATION ${config_folder} COMPONENT gonogo)
install(EXPORT gonogo-program NAMESPACE gonogo:: DESTINATION ${config_folder} COMPONENT gonogo)
install(EXPORT gonogo-oracle NAMESPACE gonogo:: DESTINATION ${config_folder} COMPONENT oracle)
