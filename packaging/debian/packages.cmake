# SPDX-License-Identifier: GPL-3.0-or-later
# The Debian packages, one for each component of the installation. packaging/make-packages.sh makes them.

set(components programs development)
if(AXISCOMP_WINDOW)
  list(APPEND components window reportpdf)
endif()
if(AXISCOMP_PYTHON)
  list(APPEND components python)
endif()
if(AXISCOMP_DOCUMENTATION) # without the site there is nothing that the window's Help could open
  list(APPEND components documentation)
endif()
set(programs_package axiscomp)
set(window_package axis-compensation-wizard)
set(reportpdf_package axiscomp-report-pdf)
set(development_package libaxiscomp-dev)
set(python_package python3-axiscomp)
set(documentation_package axiscomp-doc)

# Without a revision of Debian's own: the first package of a distribution, -1, is newer than ours.
set(package_revision 0axiscomp1)
set(package_version ${PROJECT_VERSION}-${package_revision})
set(package_homepage https://axiscomp.example.org/)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME axiscomp)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # each package has its own
set(CPACK_PACKAGE_VENDOR "Axis Compensation Wizard")
set(CPACK_PACKAGE_CONTACT "Axis Compensation Wizard maintainers <maintainers@axiscomp.example.org>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/strip.cmake ${CMAKE_CURRENT_LIST_DIR}/share_scripts.cmake)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL ${components})
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_RELEASE ${package_revision})
set(CPACK_DEBIAN_PACKAGE_HOMEPAGE ${package_homepage})
set(CPACK_DEBIAN_PACKAGE_SOURCE axis-compensation-wizard)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS OFF)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

# axiscomp_package(COMPONENT SECTION SUMMARY [NO_LIBRARIES] [ARCHITECTURE all] [DEPENDS ...] [RECOMMENDS ...]
# [SUGGESTS ...] DESCRIPTION ...): the fields of a control file. Without NO_LIBRARIES it depends on the
# libraries that its programs are linked with as well. The parts of DESCRIPTION are paragraphs.
set(common_description
"Brings the measured position errors of a machine axis (a calibration file
with one, two or three dimensions) into the servo drive, switches the
compensation on and proves that the drive adds what it should. Every write
is verified by reading it back, leaves the axis in the old state or in the
new one, or, where a drive leaves neither possible, with the compensation
switched off, and spends the drive's flash knowingly.")
macro(axiscomp_package component section summary)
  cmake_parse_arguments(arg "NO_LIBRARIES" "ARCHITECTURE" "DEPENDS;RECOMMENDS;SUGGESTS;DESCRIPTION" ${ARGN})
  string(TOUPPER ${component} upper)
  set(prefix CPACK_DEBIAN_${upper})
  set(${prefix}_PACKAGE_NAME ${${component}_package})
  set(${prefix}_PACKAGE_SECTION ${section})
  if(arg_NO_LIBRARIES)
    set(${prefix}_PACKAGE_SHLIBDEPS OFF)
  else()
    set(${prefix}_PACKAGE_SHLIBDEPS ON)
  endif()
  if(arg_ARCHITECTURE)
    set(${prefix}_PACKAGE_ARCHITECTURE ${arg_ARCHITECTURE})
  endif()
  foreach(field DEPENDS RECOMMENDS SUGGESTS)
    list(JOIN arg_${field} ", " ${prefix}_PACKAGE_${field})
  endforeach()
  list(JOIN arg_DESCRIPTION "\n\n" text)
  # The first line is the summary; CPack makes the form of a control file of the rest.
  set(${prefix}_DESCRIPTION "${summary}\n${common_description}\n\n${text}")
endmacro()

axiscomp_package(programs science "position error compensation for servo drives - command line"
  SUGGESTS axis-compensation-wizard axiscomp-doc axiscomp-report-pdf bash-completion
  DESCRIPTION
"This package has the command line program axiscomp, which needs no desktop,
axiscomp-virtualdrive, a virtual drive to try everything without hardware, and
the drive profiles, virtual machines and examples of both.")

# Qt's own texts (the buttons of its dialogs) in other languages than English; Qt draws on Wayland with a
# module of its own; Japanese and Chinese need a font that nothing else brings. Depends on the very version of
# axiscomp: both work with the same files.
axiscomp_package(window science "position error compensation for servo drives - desktop program"
  DEPENDS "axiscomp (= ${package_version})" qt6-translations-l10n
  RECOMMENDS axiscomp-doc axiscomp-report-pdf fonts-noto-cjk qt6-wayland
  DESCRIPTION
"This package has the program axis-compensation-wizard: a window in which
measurements are judged by ISO 230-2, tables fitted, plotted and written, and
the result is proved. A demo drive is part of it.")

# A page is set in DejaVu Sans (ui/report); a report in a language that no font has the characters of is refused.
axiscomp_package(reportpdf science "position error compensation for servo drives - reports as PDF"
  DEPENDS "axiscomp (= ${package_version})" fonts-dejavu-core
  RECOMMENDS fonts-noto-cjk
  DESCRIPTION
"This package has the module with which axiscomp draws a report as PDF. It
needs Qt's fonts and graphics, which no other command does. A report as HTML
needs no module.")

axiscomp_package(development libdevel "position error compensation for servo drives - development files"
  NO_LIBRARIES
  DEPENDS libc6-dev "libstdc++-12-dev | libstdc++-dev" libexpected-dev libqcustomplot-dev libsqlite3-dev
    nlohmann-json3-dev pkg-config "qt6-base-dev (>= 6.4)" "qt6-serialport-dev (>= 6.4)"
    "qt6-svg-dev (>= 6.4)" zlib1g-dev
  SUGGESTS axis-compensation-wizard axiscomp-doc cmake
  DESCRIPTION
"This package has the static libraries, headers and CMake configuration of the
parts: core (tables, formats, the safe order of a write), drivecomm (links to
drives, the virtual drive) and ui (the window as a widget for other programs).")

# The module is for one version of Python.
axiscomp_package(python python "position error compensation for servo drives - Python 3 module"
  DEPENDS "python3 (>= 3.11)" "python3 (<< 3.12)" python3-numpy
  SUGGESTS axiscomp axiscomp-doc axiscomp-report-pdf python3-distributed python3-matplotlib
  DESCRIPTION
"This package has the module axiscomp: tables and measurements over numpy
arrays, drives, and every command of the program axiscomp as a function.")

if(AXISCOMP_DOCUMENTATION)
  axiscomp_package(documentation doc "position error compensation for servo drives - documentation"
    NO_LIBRARIES ARCHITECTURE all
    DEPENDS "libjs-sphinxdoc (>= 5.3)"
    SUGGESTS axis-compensation-wizard axiscomp
    DESCRIPTION
"This package has the user guide, the reference of the command line, of the
Python module, of the C++ libraries and of all file formats, and how the
program is proved: as pages for a browser, which need no network, and as text.")
endif()
include(CPack)
