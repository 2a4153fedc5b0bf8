# gonogo_add_conformance_test(NAME name SUBJECT kind:rest DIALECTS dialect... [PROFILE file]
#   [CORPUS folder] [ALARM_MAP file] [KNOWN_FAILURES file] [LABELS label...]):
# a test NAME.DIALECT for each dialect, which certifies the subject with the corpus (the installed
# one unless CORPUS names another). It passes when the answer is GO: undecided, exit 3, is no pass.
# SUBJECT may contain generator expressions (lib:$<TARGET_FILE:acme>) and is started in the current
# source folder, from which the files are named too. The report is written to
# gonogo/NAME/DIALECT in the current binary folder.
function(gonogo_add_conformance_test)
  cmake_parse_arguments(PARSE_ARGV 0 ARG ""
    "NAME;SUBJECT;PROFILE;CORPUS;ALARM_MAP;KNOWN_FAILURES" "DIALECTS;LABELS")
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
  foreach(dialect IN LISTS ARG_DIALECTS)
    set(test ${ARG_NAME}.${dialect})
    add_test(NAME ${test}
      COMMAND gonogo::gonogo certify --subject "${ARG_SUBJECT}" --dialect ${dialect} ${options}
              --report "${CMAKE_CURRENT_BINARY_DIR}/gonogo/${ARG_NAME}/${dialect}"
      WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}")
    set_tests_properties(${test} PROPERTIES LABELS "${ARG_LABELS}")
  endforeach()
endfunction()
