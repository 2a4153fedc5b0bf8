# Everything comes from Debian 12 packages; nothing is downloaded.
find_package(Boost 1.74 REQUIRED)
find_package(CGAL REQUIRED)
find_package(CLI11 REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(simdjson REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(Threads REQUIRED)

foreach(library gmp gmpxx mpfr nettle z)
  find_library(GONOGO_${library} ${library} REQUIRED)
  add_library(gonogo_external_${library} INTERFACE)
  target_link_libraries(gonogo_external_${library} INTERFACE
    $<BUILD_INTERFACE:${GONOGO_${library}}> $<INSTALL_INTERFACE:${library}>)
endforeach()
target_link_libraries(gonogo_external_gmpxx INTERFACE gonogo_external_gmp)
target_link_libraries(gonogo_external_mpfr INTERFACE gonogo_external_gmp)

if(GONOGO_TESTS)
  find_package(GTest REQUIRED)
  find_package(rapidcheck REQUIRED)
  find_package(benchmark REQUIRED)
endif()
