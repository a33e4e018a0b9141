# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the build PROJECT_BUILD into WORK, runs the installed programs, then configures, builds
# and runs the project CONSUMER with nothing but what was installed.
function(run)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}: ${status}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(expect text pattern)
  if(NOT text MATCHES "${pattern}")
    message(FATAL_ERROR "'${pattern}' is expected in:\n${text}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
set(prefix ${WORK}/prefix)
run(${CMAKE_COMMAND} --install ${PROJECT_BUILD} --prefix ${prefix})
string(REPLACE "." "\\." version "${VERSION}")
foreach(program axiscomp axiscomp-virtualdrive)
  run(${prefix}/bin/${program} --version)
  expect("${output}" "${version}")
  foreach(file share/man/man1/${program}.1.gz share/bash-completion/completions/${program})
    if(NOT EXISTS ${prefix}/${file})
      message(FATAL_ERROR "${file} is not installed")
    endif()
  endforeach()
endforeach()

run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${WORK}/build -G Ninja -DCMAKE_BUILD_TYPE=Debug
    -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_PREFIX_PATH=${prefix})
expect("${output}" "Build files have been written")
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/consumer ${WORK}/state)
expect("${output}" "halfway 0\\.5\n")
expect("${output}" "axis 0 ")
