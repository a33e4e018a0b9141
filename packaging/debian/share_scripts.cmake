# SPDX-License-Identifier: GPL-3.0-or-later
# Takes the scripts of the documentation site from the package that Debian has for them, as dh_sphinxdoc does: what is
# the same there becomes a link. CPack runs it when all files are in place.
set(shared /usr/share/javascript/sphinxdoc/1.0)
file(GLOB_RECURSE scripts ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*.js)
list(FILTER scripts INCLUDE REGEX "/html/_static/")
foreach(script ${scripts})
  get_filename_component(name ${script} NAME)
  if(EXISTS ${shared}/${name})
    file(READ ${script} own)
    file(READ ${shared}/${name} theirs)
    if(own STREQUAL theirs)
      # from /usr/share/doc/axiscomp-doc/html/_static: Debian wants it relative below /usr
      file(CREATE_LINK ../../../../javascript/sphinxdoc/1.0/${name} ${script} SYMBOLIC)
    endif()
  endif()
endforeach()
# Of the theme; no page asks for it.
file(GLOB_RECURSE unused ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/normalize.css)
if(unused)
  file(REMOVE ${unused})
endif()
