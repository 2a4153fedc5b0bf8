# gonogo_add_conformance_test(NAME name SUBJECT kind:rest DIALECTS dialect... [CYCLES cycle...]
#   [ONLY glob...] [READING key=value...] [TOLERANCE mm] [PROFILE file] [CORPUS folder]
#   [ALARM_MAP file] [KNOWN_FAILURES file] [LABELS label...] [CASES]):
# tests that certify the subject with the corpus (the installed one unless CORPUS names another):
#   NAME.DIALECT.CYCLE  one for each cycle of the corpus (or of CYCLES); skipped where the subject
#                       claims none of its cases
#   NAME.DIALECT        all of them in one run, which holds the cycles to one set of readings, and in
#                       which something has to be judged
# and with CASES
#   NAME.DIALECT.case.ID  one for each case, which is skipped where it is not claimed, left open or fails
#                       as it is known to; ctest -L gonogo-case
# A test passes when the answer is GO: undecided, exit 3, is no pass. ONLY names the cases that count,
# READING and TOLERANCE are those of `gonogo certify`. SUBJECT may contain generator expressions
# (lib:$<TARGET_FILE:acme>) and is started in the current source folder, from which the files are
# named too. The reports are written to gonogo/NAME/DIALECT and gonogo/NAME/DIALECT.CYCLE in the
# current binary folder. One cycle: ctest -R 'NAME\.rs274\.threads'; all one by one: ctest -L gonogo-cycle.

# The first word of each line of `gonogo corpus WHAT`, or the second, when the project is configured.
function(gonogo_corpus_words what place dialect list)
  cmake_parse_arguments(PARSE_ARGV 4 ARG "" "CORPUS" "ONLY")
  get_target_property(program gonogo::gonogo LOCATION)
  set(words corpus ${what} --dialect ${dialect})
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
  list(TRANSFORM lines REPLACE "^([^ ]+) +([^ ]+)( .*)?$" "\\${place}")
  set(${list} "${lines}" PARENT_SCOPE)
endfunction()

function(gonogo_add_conformance_test)
  cmake_parse_arguments(PARSE_ARGV 0 ARG "CASES"
    "NAME;SUBJECT;PROFILE;CORPUS;ALARM_MAP;KNOWN_FAILURES;TOLERANCE" "DIALECTS;CYCLES;ONLY;READING;LABELS")
  foreach(needed NAME SUBJECT DIALECTS)
    if(NOT ARG_${needed})
      message(FATAL_ERROR "gonogo_add_conformance_test needs ${needed}.")
    endif()
  endforeach()
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "gonogo_add_conformance_test knows no ${ARG_UNPARSED_ARGUMENTS}.")
  endif()
  if(ARG_CASES AND ARG_CYCLES)
    message(FATAL_ERROR "gonogo_add_conformance_test: CASES are chosen by ONLY, not by CYCLES.")
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
  foreach(option READING TOLERANCE)
    string(TOLOWER "--${option}" name)
    foreach(value IN LISTS ARG_${option})
      list(APPEND options ${name} "${value}")
    endforeach()
  endforeach()
  set(only "")
  foreach(glob IN LISTS ARG_ONLY)
    list(APPEND only --only "${glob}")
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
    add_test(NAME ${test} COMMAND ${certify} ${only} ${chosen} --report "${reports}/${dialect}"
      WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}")
    set_tests_properties(${test} PROPERTIES LABELS "${ARG_LABELS}")

    gonogo_corpus_words(cycles 2 ${dialect} cycles CORPUS "${corpus}" ONLY ${ARG_ONLY})
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
        COMMAND ${certify} ${only} --cycle ${cycle} --report "${reports}/${dialect}.${cycle}"
        WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}")
      # Every case is skipped: there is no other line of totals.
      set_tests_properties(${test}.${cycle} PROPERTIES LABELS "${ARG_LABELS};gonogo-cycle"
        SKIP_REGULAR_EXPRESSION " cases\n  skip +[0-9]+\n  not claimed of [^\n]*\n  There is a dialect in which no case")
    endforeach()

    if(ARG_CASES)
      gonogo_corpus_words(list 1 ${dialect} cases CORPUS "${corpus}" ONLY ${ARG_ONLY})
      foreach(case IN LISTS cases)
        add_test(NAME ${test}.case.${case}
          COMMAND ${certify} --only ${case} --report "${reports}/${dialect}.cases/${case}"
          WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}")
        set_tests_properties(${test}.case.${case} PROPERTIES LABELS "${ARG_LABELS};gonogo-case"
          SKIP_REGULAR_EXPRESSION "\n  (skip|xfail|oracle-gap|advice) +1\n")
      endforeach()
    endif()
  endforeach()
endfunction()
