# SPDX-License-Identifier: GPL-3.0-or-later

# What packaging/ makes Debian packages of: "programs" and "development".
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
if(AXISCOMP_SANITIZERS AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # What is added to every access hides from GCC which member of a std::variant was set and how long a
  # std::string is. These warnings follow the values and are false then; the other presets have them.
  list(APPEND AXISCOMP_SANITIZERS -Wno-maybe-uninitialized -Wno-array-bounds -Wno-restrict
    -Wno-stringop-overflow -Wno-stringop-overread)
endif()

add_library(axiscomp_options INTERFACE)
target_compile_options(axiscomp_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor -Woverloaded-virtual
  $<$<BOOL:${AXISCOMP_WERROR}>:-Werror>
  ${AXISCOMP_SANITIZERS})
target_link_options(axiscomp_options INTERFACE ${AXISCOMP_SANITIZERS})
target_compile_definitions(axiscomp_options INTERFACE
  QT_NO_KEYWORDS QT_NO_CAST_FROM_ASCII QT_NO_CAST_TO_ASCII QT_NO_URL_CAST_FROM_STRING
  QT_DISABLE_DEPRECATED_BEFORE=0x060400)

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

# A static library axiscomp::NAME. HEADERS is its public interface: every header of it must compile
# alone with nothing but what PUBLIC_DEPS give, which is how the direction between the parts is kept
# (target all_verify_interface_header_sets).
function(axiscomp_add_module name)
  cmake_parse_arguments(arg "" "" "HEADERS;SOURCES;PUBLIC_DEPS;PRIVATE_DEPS;PRECOMPILE" ${ARGN})
  set(target axiscomp_${name})
  add_library(${target} STATIC ${arg_SOURCES})
  add_library(axiscomp::${name} ALIAS ${target})
  target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${arg_HEADERS})
  target_link_libraries(${target} PUBLIC ${arg_PUBLIC_DEPS} PRIVATE $<BUILD_INTERFACE:axiscomp_options> ${arg_PRIVATE_DEPS})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  axiscomp_precompile(${target} ${AXISCOMP_COMMON_HEADERS} ${arg_PRECOMPILE})
endfunction()

# Qt tells every test its folders (for QFINDTESTDATA, not used here); then no two folders could share
# precompiled headers.
set(AXISCOMP_SAME_FOLDER -UQT_TESTCASE_BUILDDIR -UQT_TESTCASE_SOURCEDIR)

# A Qt Test executable NAME from NAME.cpp, labelled with its module. PLAIN: its options differ from
# those that the tests' headers were precompiled with. THREADED: ThreadSanitizer has something to look
# at, and sees all of it (Qt itself is not instrumented: it does not see the locks of Qt's event queue).
add_custom_target(threaded-tests)
function(axiscomp_add_test name)
  cmake_parse_arguments(arg "PLAIN;THREADED" "MODULE" "SOURCES;DEPS" ${ARGN})
  add_executable(${name} ${name}.cpp ${arg_SOURCES})
  set_target_properties(${name} PROPERTIES AUTOMOC ON)
  target_link_libraries(${name} PRIVATE axiscomp_options Qt6::Test axiscomp_test_support ${arg_DEPS})
  if(AXISCOMP_PCH AND NOT arg_PLAIN)
    set(headers axiscomp_test_headers)
    if(arg_MODULE STREQUAL ui)
      set(headers axiscomp_window_test_headers)
    endif()
    target_precompile_headers(${name} REUSE_FROM ${headers})
    target_compile_options(${name} PRIVATE ${AXISCOMP_SAME_FOLDER})
    # A test's moc file is part of the test itself; this one is empty.
    set_source_files_properties(${CMAKE_CURRENT_BINARY_DIR}/${name}_autogen/mocs_compilation.cpp
      PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
  endif()
  add_test(NAME ${name} COMMAND ${name})
  set(labels ${arg_MODULE})
  if(arg_THREADED)
    list(APPEND labels threads)
    add_dependencies(threaded-tests ${name})
  endif()
  set_tests_properties(${name} PROPERTIES
    LABELS "${labels}" TIMEOUT 900
    ENVIRONMENT "QT_QPA_PLATFORM=offscreen;LC_ALL=C.UTF-8")
endfunction()
