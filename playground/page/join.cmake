# cmake -DOUTPUT=playground.html -DMODULE=gonogo.wasm -DASSETS=folder -DPAGE=folder -DBASE64=program -P join.cmake
#
# The page with its style, scripts and the module in it. Marks are replaced from the back, so that no text
# that is put in is searched again for what follows it.
execute_process(COMMAND ${BASE64} -w 0 ${MODULE} OUTPUT_VARIABLE module COMMAND_ERROR_IS_FATAL ANY)
file(READ ${PAGE}/playground.html page)
function(joined out)
  set(text "")
  foreach(file IN LISTS ARGN)
    file(READ ${file} part)
    string(APPEND text "${part}")
  endforeach()
  set(${out} "${text}" PARENT_SCOPE)
endfunction()
joined(style ${ASSETS}/report.css ${PAGE}/playground.css)
joined(worker ${PAGE}/engine.js ${PAGE}/worker.js)
joined(script ${ASSETS}/element.js ${ASSETS}/view3d.js ${PAGE}/examples.js ${PAGE}/line.js ${PAGE}/motions.js ${PAGE}/playground.js)
foreach(mark script worker module style)
  string(REPLACE "{{${mark}}}" "${${mark}}" page "${page}")
endforeach()
file(WRITE ${OUTPUT} "${page}")
