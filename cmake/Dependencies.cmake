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

# CGAL's kernel over the exact number: headers alone. It rounds nothing, so it needs neither -frounding-math
# nor the check of it, which would run in every program; what needs both links CGAL::CGAL (oracle/region).
add_library(gonogo_external_cgal INTERFACE)
target_include_directories(gonogo_external_cgal SYSTEM INTERFACE
  $<TARGET_PROPERTY:CGAL::CGAL,INTERFACE_INCLUDE_DIRECTORIES>)
target_compile_definitions(gonogo_external_cgal INTERFACE CGAL_DISABLE_ROUNDING_MATH_CHECK)

if(GONOGO_TESTS)
  find_package(GTest REQUIRED)
  find_package(rapidcheck REQUIRED)
  find_package(benchmark REQUIRED)
endif()
