# SPDX-License-Identifier: GPL-3.0-or-later
# Libraries of Debian that are headers alone, for a compiler of another system: it must not see the rest of
# /usr/include, which is for Linux. A folder of links to them, and what find_package() finds instead of Debian's
# own files. For CMAKE_PROJECT_TOP_LEVEL_INCLUDES.
set(headers ${CMAKE_BINARY_DIR}/debian_headers)
file(MAKE_DIRECTORY ${headers})
foreach(name CLI nlohmann sqlite3.h tl toml++ eigen3/Eigen)
  if(NOT EXISTS /usr/include/${name})
    message(FATAL_ERROR "/usr/include/${name} is missing: packaging/packages-run.txt has its package")
  endif()
  cmake_path(GET name FILENAME link)
  file(CREATE_LINK /usr/include/${name} ${headers}/${link} SYMBOLIC)
endforeach()

# axiscomp_header_library(PACKAGE TARGET)
function(axiscomp_header_library package target)
  file(WRITE ${CMAKE_FIND_PACKAGE_REDIRECTS_DIR}/${package}Config.cmake "
if(NOT TARGET ${target})
  add_library(${target} INTERFACE IMPORTED)
  target_include_directories(${target} INTERFACE \"${headers}\")
endif()
")
  file(WRITE ${CMAKE_FIND_PACKAGE_REDIRECTS_DIR}/${package}ConfigVersion.cmake "
set(PACKAGE_VERSION_COMPATIBLE TRUE)
")
endfunction()
axiscomp_header_library(CLI11 CLI11::CLI11)
axiscomp_header_library(Eigen3 Eigen3::Eigen)
axiscomp_header_library(nlohmann_json nlohmann_json::nlohmann_json)
axiscomp_header_library(tl-expected tl::expected)
