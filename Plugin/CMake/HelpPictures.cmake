# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
# Puts pictures into the help pages that ParaView makes of a plugin's XML: that has no element for one. ParaView packs
# what lies in FOLDER over its own pages of the same name.
# usage: cmake -DGENERATED=FOLDER_OF_PAGES -DPICTURES=FOLDER_OF_PICTURES -DFOLDER=RESULT -P HelpPictures.cmake
cmake_minimum_required(VERSION 3.25)

set(pictures
  "GeodesicCentre centre.png"
  "GeodesicDistance picking-seeds.png"
  "GeodesicDistanceMatrix distance-matrix.png"
  "GeodesicIsolines isolines.png"
  "GeodesicPath path-numbers.png"
  "GeodesicRegion regions.png"
  "GeodesicSamples samples.png")
# The help window is narrower than a screenshot.
set(width 600)

file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")
foreach (entry IN LISTS pictures)
  separate_arguments(entry)
  list(GET entry 0 filter)
  list(GET entry 1 picture)
  set(page "filters.${filter}.html")
  file(READ "${GENERATED}/${page}" text)
  # The page may be one that a run before has put there.
  string(REGEX REPLACE "<p><img [^>]*></p>" "" text "${text}")
  string(REPLACE "<div class=\"description\">" "<p><img src=\"${picture}\" width=\"${width}\"></p><div class=\"description\">"
    illustrated "${text}")
  if (text STREQUAL illustrated)
    message(FATAL_ERROR "${GENERATED}/${page} has no place for a picture: no <div class=\"description\">")
  endif ()
  file(WRITE "${FOLDER}/${page}" "${illustrated}")
  file(COPY "${PICTURES}/${picture}" DESTINATION "${FOLDER}")
endforeach ()
