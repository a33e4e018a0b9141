# SPDX-License-Identifier: GPL-3.0-or-later
# Takes out of what is packed what Debian's dh_strip takes out. CPack runs it when all files are in place.
file(GLOB_RECURSE files LIST_DIRECTORIES OFF ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*)
foreach(file ${files})
  file(READ ${file} magic LIMIT 8 HEX)
  set(options "")
  if(magic MATCHES "^7f454c46") # ELF
    set(options --strip-unneeded)
  elseif(magic MATCHES "^213c617263683e0a") # ar
    set(options --strip-debug --enable-deterministic-archives)
  endif()
  if(options)
    execute_process(COMMAND strip ${options} --remove-section=.comment --remove-section=.note ${file}
                    COMMAND_ERROR_IS_FATAL ANY)
  endif()
endforeach()
