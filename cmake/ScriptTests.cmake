# gonogo_add_script_test(NAME name LABEL label COMMAND program argument... [NEEDS variable...]
#                        [WITHOUT sentence] [ENVIRONMENT A=B...] [TIMEOUT seconds]):
# a test that is a script. When one of the variables NEEDS (of find_program) is empty, or when the
# script itself prints a line "SKIPPED: ...", the test counts as skipped and says why.
function(gonogo_add_script_test)
  cmake_parse_arguments(ARG "" "NAME;LABEL;WITHOUT;TIMEOUT" "COMMAND;NEEDS;ENVIRONMENT" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 2400)  # a loaded machine takes long; what hangs ends all the same
  endif()
  foreach(needed IN LISTS ARG_NEEDS)
    if(NOT ${needed})
      set(ARG_COMMAND ${CMAKE_COMMAND} -E echo "SKIPPED: ${ARG_WITHOUT}")
    endif()
  endforeach()
  add_test(NAME ${ARG_NAME} COMMAND ${ARG_COMMAND})
  set_tests_properties(${ARG_NAME} PROPERTIES LABELS "${ARG_LABEL}" TIMEOUT ${ARG_TIMEOUT}
    ENVIRONMENT "${ARG_ENVIRONMENT}" SKIP_REGULAR_EXPRESSION "(^|\n)SKIPPED: ")
endfunction()

# LinuxCNC's and FreeCAD's modules belong to the system's Python, not to another one in the PATH.
find_program(GONOGO_PYTHON NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_program(GONOGO_NODE NAMES node nodejs)
