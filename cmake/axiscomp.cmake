# SPDX-License-Identifier: GPL-3.0-or-later

# packaging/ makes a Debian package of each component; this is the one of the command line.
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME programs)

set(AXISCOMP_SANITIZERS "")
if(AXISCOMP_SANITIZE AND AXISCOMP_SANITIZE_THREADS)
  message(FATAL_ERROR "AXISCOMP_SANITIZE and AXISCOMP_SANITIZE_THREADS cannot be in one program")
elseif(AXISCOMP_SANITIZE)
  # GCC's "undefined" leaves out a floating-point number that does not fit into an integer.
  set(AXISCOMP_SANITIZERS -fsanitize=address,undefined,float-cast-overflow
    -fno-sanitize-recover=all -fno-omit-frame-pointer)
elseif(AXISCOMP_SANITIZE_THREADS)
  set(AXISCOMP_SANITIZERS -fsanitize=thread -fno-omit-frame-pointer)
endif()
if(AXISCOMP_SANITIZE AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # A check of UndefinedBehaviorSanitizer ends with an instruction that AddressSanitizer reports with its line
  # (handle_sigill=1) instead of a sentence, whose parts make a program three times as large.
  list(APPEND AXISCOMP_SANITIZERS -fsanitize-undefined-trap-on-error)
endif()
if(AXISCOMP_SANITIZERS AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # What is added to every access hides from GCC which member of a std::variant was set and how long a
  # std::string is. These warnings follow the values and are false then; the other presets have them.
  list(APPEND AXISCOMP_SANITIZERS -Wno-maybe-uninitialized -Wno-array-bounds -Wno-restrict
    -Wno-stringop-overflow -Wno-stringop-overread)
endif()
# Of all targets, before what one of them leaves out: the last option decides.
add_compile_options(${AXISCOMP_SANITIZERS})
add_link_options(${AXISCOMP_SANITIZERS})

# Files that are compiled together see each other's constants and anonymous namespaces; these two warnings
# would speak of that.
if(CMAKE_UNITY_BUILD)
  set(single_file_warnings -Wno-subobject-linkage)
else()
  set(single_file_warnings -Wshadow)
endif()

# Without contraction a * b + c is rounded twice on every processor: core/table/lookup_batch.cpp is compiled
# for some that could do it in one operation, whose bits would differ.
add_library(axiscomp_options INTERFACE)
target_compile_options(axiscomp_options INTERFACE
  -ffp-contract=off
  -Wall -Wextra -Wpedantic ${single_file_warnings} -Wconversion -Wnon-virtual-dtor -Woverloaded-virtual
  $<$<BOOL:${AXISCOMP_WERROR}>:-Werror>)
if(WIN32)
  # UNICODE: only functions that take UTF-16 are meant.
  target_compile_definitions(axiscomp_options INTERFACE NOMINMAX WIN32_LEAN_AND_MEAN UNICODE)
endif()
target_compile_definitions(axiscomp_options INTERFACE
  QT_NO_KEYWORDS QT_NO_CAST_FROM_ASCII QT_NO_CAST_TO_ASCII QT_NO_URL_CAST_FROM_STRING
  QT_DISABLE_DEPRECATED_BEFORE=0x060400)

# GCC collects its garbage from 128 MB on, which is 10 to 17 % of the time of a unit that is compiled alone;
# without, a compiler takes half as much memory again.
cmake_host_system_information(RESULT memory QUERY TOTAL_PHYSICAL_MEMORY) # in MiB
if(CMAKE_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL GNU AND memory GREATER_EQUAL 8000)
  math(EXPR heap "${memory} * 1024 / 24")
  target_compile_options(axiscomp_options INTERFACE "SHELL:--param ggc-min-heapsize=${heap}")
endif()

# The headers of others that every file of a target reads, compiled once: most of the time of a build
# goes into them. Only with AXISCOMP_PCH, so that builds without it find the missing include.
function(axiscomp_precompile target)
  if(AXISCOMP_PCH)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()
set(AXISCOMP_COMMON_HEADERS
  <algorithm> <array> <charconv> <chrono> <cmath> <cstdint> <filesystem> <functional> <limits> <map>
  <memory> <optional> <set> <span> <stop_token> <string> <string_view> <thread> <utility> <variant>
  <vector> <tl/expected.hpp>)

# Without these checks of TARGET beside AddressSanitizer, for which much of the time of a build went.
function(axiscomp_leave_unchecked target checks)
  if(AXISCOMP_SANITIZE AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    target_compile_options(${target} PRIVATE -fno-sanitize=${checks})
  endif()
endfunction()
# Of code that takes no bytes apart. AddressSanitizer finds what is read through a null pointer or beyond an
# object.
set(AXISCOMP_CHECKS_OF_ACCESS null,alignment,object-size)

# A static library axiscomp::NAME; the files of its folders come by axiscomp_add_sources.
function(axiscomp_add_module name)
  cmake_parse_arguments(arg "" "" "PUBLIC_DEPS;PRIVATE_DEPS;PRECOMPILE" ${ARGN})
  set(target axiscomp_${name})
  add_library(${target} STATIC)
  add_library(axiscomp::${name} ALIAS ${target})
  target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR})
  target_link_libraries(${target} PUBLIC ${arg_PUBLIC_DEPS} PRIVATE $<BUILD_INTERFACE:axiscomp_options> ${arg_PRIVATE_DEPS})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  axiscomp_precompile(${target} ${AXISCOMP_COMMON_HEADERS} ${arg_PRECOMPILE})
endfunction()

# The files of one folder, for the library axiscomp_NAME. HEADERS is what other parts may include:
# every header of it must compile alone with nothing but what the PUBLIC_DEPS of the library give,
# which is how the direction between the parts is kept (target all_verify_interface_header_sets).
# POSIX, WINDOWS: for these systems only. DRIVES: not without AXISCOMP_DRIVES. Where there is a library axiscomp_NAME_quick,
# it has the SOURCES, and axiscomp_NAME has them from there (app/cli).
function(axiscomp_add_sources name)
  cmake_parse_arguments(arg "" "" "HEADERS;SOURCES;POSIX;WINDOWS;DRIVES" ${ARGN})
  list(TRANSFORM arg_HEADERS PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  if(TARGET axiscomp_${name}_quick)
    target_sources(axiscomp_${name}_quick PRIVATE ${arg_SOURCES})
  else()
    target_sources(axiscomp_${name} PRIVATE ${arg_SOURCES})
  endif()
  if(WIN32)
    target_sources(axiscomp_${name} PRIVATE ${arg_WINDOWS})
    # windows.h has macros of everyday words, which are for no other file.
    set_source_files_properties(${arg_WINDOWS} TARGET_DIRECTORY axiscomp_${name}
      PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  else()
    target_sources(axiscomp_${name} PRIVATE ${arg_POSIX})
  endif()
  if(AXISCOMP_DRIVES)
    target_sources(axiscomp_${name} PRIVATE ${arg_DRIVES})
  elseif(TARGET axiscomp_${name}_unlinked)
    target_sources(axiscomp_${name}_unlinked PRIVATE ${arg_DRIVES})
  endif()
  if(arg_HEADERS)
    target_sources(axiscomp_${name} PUBLIC FILE_SET HEADERS FILES ${arg_HEADERS})
  endif()
endfunction()

# Lets CMake run moc for the files of TARGET.
function(axiscomp_moc target)
  set_target_properties(${target} PROPERTIES AUTOMOC ON)
  if(CMAKE_HOST_UNIX)
    set(script ${PROJECT_BINARY_DIR}/moc.sh)
    get_target_property(moc Qt6::moc LOCATION)
    configure_file(${PROJECT_SOURCE_DIR}/cmake/moc.sh.in ${script} @ONLY USE_SOURCE_PERMISSIONS)
    set_target_properties(${target} PROPERTIES AUTOMOC_EXECUTABLE ${script})
  endif()
endfunction()

# The program test_NAME, which runs one of the tests of a part: `test_NAME tst_thing [FUNCTION ...]`.
# One program, since a test links in less time than it compiles and both add up. WINDOW: for tests with
# widgets. RUNS_PROGRAMS: its tests start the programs of app.
function(axiscomp_add_test_program name)
  cmake_parse_arguments(arg "WINDOW;RUNS_PROGRAMS" "" "SOURCES;DEPS" ${ARGN})
  set(target test_${name})
  add_executable(${target} ${PROJECT_SOURCE_DIR}/tests/support/test_main.cpp ${arg_SOURCES})
  axiscomp_moc(${target})
  target_link_libraries(${target} PRIVATE axiscomp_options axiscomp_test_support ${arg_DEPS})
  # The product that the tests call is checked.
  axiscomp_leave_unchecked(${target} undefined,float-cast-overflow)
  target_compile_definitions(${target} PRIVATE AXISCOMP_SOURCE_FOLDER="${PROJECT_SOURCE_DIR}")
  set(headers ${AXISCOMP_COMMON_HEADERS} <QTest>)
  if(arg_WINDOW)
    list(APPEND headers <QComboBox> <QFuture> <QPushButton> <QSignalSpy>)
  endif()
  axiscomp_precompile(${target} ${headers})
  if(arg_RUNS_PROGRAMS)
    target_sources(${target} PRIVATE ${PROJECT_SOURCE_DIR}/tests/app/program_run.cpp)
    target_compile_definitions(${target} PRIVATE
      AXISCOMP_PROGRAM="$<TARGET_FILE:axiscomp>"
      AXISCOMP_VIRTUALDRIVE_PROGRAM="$<TARGET_FILE:axiscomp-virtualdrive>"
      AXISCOMP_PROGRAM_FOLDER="$<TARGET_FILE_DIR:axiscomp>")
    # Command lines and what programs say are written as plain literals.
    target_compile_options(${target} PRIVATE -UQT_NO_CAST_FROM_ASCII)
    add_dependencies(${target} axiscomp axiscomp-virtualdrive)
  endif()
endfunction()

# What a program for Windows says of itself: that it takes UTF-8 and long names.
function(axiscomp_add_manifest target)
  if(MSVC)
    target_sources(${target} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/windows/program.manifest)
  elseif(WIN32)
    enable_language(RC)
    target_sources(${target} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/windows/program.rc)
  endif()
endfunction()

# Tests of one folder, for the program test_NAME: each is NAME.cpp, a test of ctest, and labelled with
# its part. THREADED: those where ThreadSanitizer has something to look at, and sees all of it (Qt itself
# is not instrumented: it does not see the locks of Qt's event queue).
add_custom_target(threaded-tests)
function(axiscomp_add_tests part)
  cmake_parse_arguments(arg "" "" "TESTS;THREADED" ${ARGN})
  foreach(test ${arg_TESTS})
    target_sources(test_${part} PRIVATE ${test}.cpp)
    add_test(NAME ${test} COMMAND test_${part} ${test})
    set(labels ${part})
    if(test IN_LIST arg_THREADED)
      list(APPEND labels threads)
      add_dependencies(threaded-tests test_${part})
    endif()
    set_tests_properties(${test} PROPERTIES
      LABELS "${labels}" TIMEOUT 1800
      ENVIRONMENT "QT_QPA_PLATFORM=offscreen;LC_ALL=C.UTF-8")
  endforeach()
endfunction()

# Newer formats note when each file was changed last, and the same sources would give other programs.
set(AXISCOMP_RESOURCE_OPTIONS OPTIONS --format-version 1)

# axiscomp_translate(TRANSLATIONS MESSAGES ENTRIES) sets the variables of these names: the .ts files, a
# language each; what lrelease makes of them in this folder's build; and the entries of a .qrc file.
function(axiscomp_translate translations_variable messages_variable entries_variable)
  file(GLOB translations CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/translations/axiscomp_*.ts)
  set(all_messages "")
  set(entries "")
  foreach(translation ${translations})
    cmake_path(GET translation STEM language)
    set(messages ${CMAKE_CURRENT_BINARY_DIR}/${language}.qm)
    add_custom_command(OUTPUT ${messages}
      COMMAND Qt6::lrelease -silent ${translation} -qm ${messages}
      DEPENDS ${translation} VERBATIM)
    list(APPEND all_messages ${messages})
    string(APPEND entries "    <file alias=\"${language}.qm\">${messages}</file>\n")
  endforeach()
  set(${translations_variable} ${translations} PARENT_SCOPE)
  set(${messages_variable} ${all_messages} PARENT_SCOPE)
  set(${entries_variable} "${entries}" PARENT_SCOPE)
endfunction()
