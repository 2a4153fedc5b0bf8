# `cpack -G DEB`: gonogo, and libgonogo-oracle-dev beside it.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME gonogo)
set(CPACK_PACKAGE_CONTACT "The GoNoGo authors <gonogo@example.org>")
set(CPACK_PACKAGE_VENDOR "The GoNoGo authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "master gauge for CNC canned cycles")
set(CPACK_RESOURCE_FILE_LICENSE ${CMAKE_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL gonogo oracle)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)

set(CPACK_DEBIAN_GONOGO_PACKAGE_NAME gonogo)
set(CPACK_DEBIAN_GONOGO_PACKAGE_SECTION science)
set(CPACK_DEBIAN_GONOGO_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENT_GONOGO_DESCRIPTION
"master gauge for CNC canned cycles
 GoNoGo holds a formal, executable reading of what controller manuals say that
 their cycles do, and tells whether somebody else's implementation of the same
 cycles is GO or NO-GO: same path, same order, same feeds, same alarms.
 .
 This package holds the program, the conformance corpus, the C header and the
 protocol helpers for subjects, a CMake package and examples.")

set(CPACK_DEBIAN_ORACLE_PACKAGE_NAME libgonogo-oracle-dev)
set(CPACK_DEBIAN_ORACLE_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_ORACLE_PACKAGE_DEPENDS
  "gonogo (= ${PROJECT_VERSION}), libfmt-dev, libgmp-dev, libmpfr-dev, libsimdjson-dev, libtomlplusplus-dev, nettle-dev, nlohmann-json3-dev, zlib1g-dev")
set(CPACK_COMPONENT_ORACLE_DESCRIPTION
"master gauge for CNC canned cycles, static libraries
 Grammar, reference and oracle of GoNoGo as C++ libraries, for programs that
 judge cycles themselves.")
include(CPack)
