# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
# What differs from one version of ParaView and VTK to another, each with the version that needs it. What differs in
# C++ is in Filters/Bridge/filter/VtkVersions.h and Widgets/Seeds/ParaViewVersions.h. Installed as well, for
# find_package(SurfaceGeodesics).

# Needed by GCC 13 to 16: at -O3 they follow values through inlined containers of the standard library and warn of what
# can't be. There warnings are no errors by default; GCC 12 and Clang check the same code.
function (get_wrong_warnings variable)
  set("${variable}" "" PARENT_SCOPE)
  if (CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL "13")
    set("${variable}" -Wno-array-bounds -Wno-dangling-pointer -Wno-dangling-reference -Wno-free-nonheap-object
      -Wno-maybe-uninitialized -Wno-nonnull -Wno-stringop-overflow -Wno-stringop-overread PARENT_SCOPE)
  endif ()
endfunction ()

# Needed by Debian's ParaView 5.13 and 6.1, whose CMake files say vtkX.so of Python modules that are called
# vtkX.cpython-<version>-<system>.so. CMake stops where an imported file is missing, although nothing links these. It
# does not look at targets of which it is told that they are a framework for Apple's systems.
# Says so of those targets in the CMake files of a folder.
function (accept_renamed_python_modules folder)
  string(REGEX REPLACE "/lib(/.*|$)" "" prefix "${folder}")
  file(GLOB exports "${folder}/*Python*-targets-*.cmake")
  foreach (export IN LISTS exports)
    file(STRINGS "${export}" checks REGEX "_cmake_import_check_files_for_")
    foreach (check IN LISTS checks)
      if (NOT check MATCHES "_for_([^ ]+) \"[$]{_IMPORT_PREFIX}/([^\"]+)[.]so\"")
        continue ()
      endif ()
      set(target "${CMAKE_MATCH_1}")
      set(module "${prefix}/${CMAKE_MATCH_2}")
      file(GLOB renamed "${module}.cpython-*.so")
      if (renamed AND NOT EXISTS "${module}.so")
        set("_cmake_import_check_xcframework_for_${target}" "${folder}" PARENT_SCOPE)
      endif ()
    endforeach ()
  endforeach ()
endfunction ()

# ParaView says which Qt it uses from 5.12 on; before, it is Qt 5.
function (get_qt_of_paraview variable)
  if (DEFINED PARAVIEW_QT_MAJOR_VERSION)
    set("${variable}" "Qt${PARAVIEW_QT_MAJOR_VERSION}" PARENT_SCOPE)
  else ()
    set("${variable}" Qt5 PARENT_SCOPE)
  endif ()
endfunction ()

# What the playback of tests calls the file dialog of the plugin manager: 5.13 gives it no name.
function (get_plugin_file_dialog variable)
  if (ParaView_VERSION VERSION_GREATER_EQUAL "5.13" AND ParaView_VERSION VERSION_LESS "6.0")
    set("${variable}" 1pqFileDialog0 PARENT_SCOPE)
  else ()
    set("${variable}" pqFileDialog PARENT_SCOPE)
  endif ()
endfunction ()

# The program by which ParaView makes the help pages of a plugin: with Qt 5 one of Qt's, from 6.1 on xsltproc. Before
# that it makes none with Qt 6: the variable is empty then.
function (get_help_program_of_paraview variable qt)
  if (qt STREQUAL "Qt5")
    set("${variable}" xmlpatterns PARENT_SCOPE)
  elseif (ParaView_VERSION VERSION_GREATER_EQUAL "6.1")
    set("${variable}" xsltproc PARENT_SCOPE)
  else ()
    set("${variable}" "" PARENT_SCOPE)
  endif ()
endfunction ()
