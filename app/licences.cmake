# What the program is made of: name | licence | Debian's package, whose copyright file holds the text | a regular expression of
# the targets or files by which it is linked; none for what is used without.
set(sonoskin_licences
  "Dear ImGui|MIT|libimgui-dev|^imgui::"
  "GLFW|zlib|libglfw3-dev|^glfw$"
  "glad|MIT|python3-glad|^glad$"
  "GLM|MIT|libglm-dev|^glm::"
  "EGL of GLVND|MIT|libegl-dev|^OpenGL::EGL$"
  "Xlib|MIT|libx11-dev|^X11::"
  "FreeType|FreeType licence|libfreetype-dev|^Freetype::"
  "ITK|Apache 2.0|libinsighttoolkit5-dev|^(ITK|itk)"
  "GDCM|BSD|libgdcm-dev|gdcm"
  "Eigen|MPL 2.0|libeigen3-dev|^Eigen3::"
  "nanoflann|BSD|libnanoflann-dev|^nanoflann::"
  "Qhull|Qhull licence|libqhull-dev|^qhull::"
  "assimp|BSD|libassimp-dev|^assimp::"
  "meshoptimizer|MIT|libmeshoptimizer-dev|^meshoptimizer::"
  "Draco|Apache 2.0|libdraco-dev|^draco::"
  "fmt|MIT|libfmt-dev|^fmt::"
  "JSON for Modern C++|MIT|nlohmann-json3-dev|^nlohmann_json::"
  "CLI11|BSD|libcli11-dev|^CLI11::"
  "Expat|MIT|libexpat1-dev|^EXPAT::"
  "MiniZip|zlib|libminizip-dev|^minizip::"
  "zlib|zlib|zlib1g-dev|^ZLIB::|/libz.so"
  "bzip2|bzip2 licence|libbz2-dev|^BZip2::"
  "libdeflate|MIT|libdeflate-dev|^libdeflate::"
  "xxHash|BSD|libxxhash-dev|^xxhash::"
  "stb|public domain or MIT|libstb-dev|^stb::"
  "Inter|OFL 1.1|fonts-inter|"
  "DejaVu Sans|Bitstream Vera licence|fonts-dejavu-core|")

# licence_of(<variable> <linked>): the name of the part that is linked so; empty where the list has none.
function(licence_of variable linked)
  set(${variable} "" PARENT_SCOPE)
  foreach(entry ${sonoskin_licences})
    string(REGEX MATCH "^([^|]*)\\|[^|]*\\|[^|]*\\|(.*)$" fits "${entry}")
    set(name "${CMAKE_MATCH_1}")
    set(links "${CMAKE_MATCH_2}")  # which the next match overwrites
    if(links AND linked MATCHES "${links}")
      set(${variable} "${name}" PARENT_SCOPE)
    endif()
  endforeach()
endfunction()

# check_licences(<target>...): nothing is linked whose licence the program does not show. The compiler's and the system's own
# libraries need no word.
function(check_licences)
  set(nameless "")
  foreach(target ${ARGN})
    get_target_property(libraries ${target} LINK_LIBRARIES)
    get_target_property(passed_on ${target} INTERFACE_LINK_LIBRARIES)
    foreach(linked ${libraries} ${passed_on})
      string(REGEX REPLACE "^\\$<LINK_ONLY:(.*)>$" "\\1" linked "${linked}")
      if(linked MATCHES "^sonoskin_|^Threads::|^dl$|NOTFOUND$|^-")
        continue()
      endif()
      licence_of(name "${linked}")
      if(NOT name)
        list(APPEND nameless "${linked}")
      endif()
    endforeach()
  endforeach()
  if(nameless)
    message(FATAL_ERROR "app/licences.cmake does not name the licences of what is linked: ${nameless}")
  endif()
endfunction()
