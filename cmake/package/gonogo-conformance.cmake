# gonogo_add_conformance_test(NAME name SUBJECT kind:rest DIALECTS dialect... [CYCLES cycle...]
#   [ONLY glob...] [READING key=value...] [TOLERANCE mm] [PROFILE file] [CORPUS folder]
#   [ALARM_MAP file] [KNOWN_FAILURES file] [LABELS label...]):
# tests that certify the subject with the corpus (the installed one unless CORPUS names another):
#   NAME.DIALECT.CYCLE  one for each cycle of the corpus (or of CYCLES); skipped where the subject
#                       claims none of its cases
#   NAME.DIALECT        all of them in one run, which holds the cycles to one set of readings, and in
#                       which something has to be judged
# A test passes when the answer is GO: undecided, exit 3, is no pass. ONLY names the cases that count,
# READING and TOLERANCE are those of `gonogo certify`. SUBJECT may contain generator expressions
# (lib:$<TARGET_FILE:acme>) and is started in the current source folder, from which the files are
# named too. The reports are written to gonogo/NAME/DIALECT and gonogo/NAME/DIALECT.CYCLE in the
# current binary folder. One cycle: ctest -R 'NAME\.rs274\.threads'; all one by one: ctest -L gonogo-cycle.

# The cycles of a dialect, as the program says when the project is configured.
function(gonogo_cycles dialect list)
  cmake_parse_arguments(PARSE_ARGV 2 ARG "" "CORPUS" "ONLY")
  get_target_property(program gonogo::gonogo LOCATION)
  set(words corpus cycles --dialect ${dialect})
  if(ARG_CORPUS)
    list(APPEND words --corpus "${ARG_CORPUS}")
  endif()
  foreach(glob IN LISTS ARG_ONLY)
    list(APPEND words --only "${glob}")
  endforeach()
  execute_process(COMMAND "${program}" ${words}
    OUTPUT_VARIABLE lines ERROR_VARIABLE error RESULT_VARIABLE code)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "gonogo_add_conformance_test: ${error}")
  endif()
  string(REGEX MATCHALL "[^\n]+" lines "${lines}")
  list(TRANSFORM lines REPLACE "^[^ ]+ ([^ ]+) .*$" "\\1")
  set(${list} "${lines}" PARENT_SCOPE)
endfunction()

function(gonogo_add_conformance_test)
  cmake_parse_arguments(PARSE_ARGV 0 ARG ""
    "NAME;SUBJECT;PROFILE;CORPUS;ALARM_MAP;KNOWN_FAILURES;TOLERANCE" "DIALECTS;CYCLES;ONLY;READING;LABELS")
  foreach(needed NAME SUBJECT DIALECTS)
    if(NOT ARG_${needed})
      message(FATAL_ERROR "gonogo_add_conformance_test needs ${needed}.")
    endif()
  endforeach()
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "gonogo_add_conformance_test knows no ${ARG_UNPARSED_ARGUMENTS}.")
  endif()
  set(options "")
  foreach(option PROFILE CORPUS ALARM_MAP KNOWN_FAILURES)
    if(ARG_${option})
      string(TOLOWER "--${option}" name)
      string(REPLACE "_" "-" name ${name})
      get_filename_component(file "${ARG_${option}}" ABSOLUTE)
      list(APPEND options ${name} "${file}")
    endif()
  endforeach()
  foreach(option ONLY READING TOLERANCE)
    string(TOLOWER "--${option}" name)
    foreach(value IN LISTS ARG_${option})
      list(APPEND options ${name} "${value}")
    endforeach()
  endforeach()
  set(corpus "")
  if(ARG_CORPUS)
    get_filename_component(corpus "${ARG_CORPUS}" ABSOLUTE)
  endif()
  set(chosen "")
  foreach(cycle IN LISTS ARG_CYCLES)
    list(APPEND chosen --cycle ${cycle})
  endforeach()

  set(reports "${CMAKE_CURRENT_BINARY_DIR}/gonogo/${ARG_NAME}")
  foreach(dialect IN LISTS ARG_DIALECTS)
    set(certify gonogo::gonogo certify --subject "${ARG_SUBJECT}" --dialect ${dialect} ${options})
    set(test ${ARG_NAME}.${dialect})
    add_test(NAME ${test} COMMAND ${certify} ${chosen} --report "${reports}/${dialect}"
      WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}")
    set_tests_properties(${test} PROPERTIES LABELS "${ARG_LABELS}")

    gonogo_cycles(${dialect} cycles CORPUS "${corpus}" ONLY ${ARG_ONLY})
    foreach(cycle IN LISTS ARG_CYCLES)
      if(NOT cycle IN_LIST cycles)
        message(FATAL_ERROR "gonogo_add_conformance_test: ${dialect} has no cycle ${cycle}, or ONLY leaves "
          "nothing of it; it has ${cycles}.")
      endif()
    endforeach()
    if(ARG_CYCLES)
      set(cycles ${ARG_CYCLES})
    endif()
    foreach(cycle IN LISTS cycles)
      add_test(NAME ${test}.${cycle}
        COMMAND ${certify} --cycle ${cycle} --report "${reports}/${dialect}.${cycle}"
        WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}")
      # Every case is skipped: there is no other line of totals.
      set_tests_properties(${test}.${cycle} PROPERTIES LABELS "${ARG_LABELS};gonogo-cycle"
        SKIP_REGULAR_EXPRESSION " cases\n  skip +[0-9]+\n  not claimed of [^\n]*\n  There is a dialect in which no case")
    endforeach()
  endforeach()
endfunction()
