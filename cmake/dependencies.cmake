# Every library the program uses, all from Debian 12. ITK is found in core/, the only layer that may see it.
find_package(Threads REQUIRED)
find_package(glm REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(nanoflann REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(CLI11 REQUIRED)
find_package(assimp REQUIRED)
find_package(ZLIB REQUIRED)
find_package(EXPAT REQUIRED)
find_package(draco REQUIRED)
find_package(meshoptimizer REQUIRED)
find_package(glfw3 3.3 REQUIRED)
find_package(X11 REQUIRED)  # tells when events happened, which GLFW does not
find_package(Freetype REQUIRED)
find_package(OpenGL REQUIRED COMPONENTS EGL)

# These ship neither a CMake package nor a module: imported targets by hand.
find_path(XXHASH_INCLUDE_DIR xxhash.h REQUIRED)
find_library(XXHASH_LIBRARY xxhash REQUIRED)
add_library(xxhash::xxhash UNKNOWN IMPORTED)
set_target_properties(xxhash::xxhash PROPERTIES IMPORTED_LOCATION ${XXHASH_LIBRARY}
                      INTERFACE_INCLUDE_DIRECTORIES ${XXHASH_INCLUDE_DIR})

find_path(STB_INCLUDE_DIR stb_image.h PATH_SUFFIXES stb REQUIRED)
find_library(STB_LIBRARY stb REQUIRED)
add_library(stb::stb UNKNOWN IMPORTED)
set_target_properties(stb::stb PROPERTIES IMPORTED_LOCATION ${STB_LIBRARY}
                      INTERFACE_INCLUDE_DIRECTORIES ${STB_INCLUDE_DIR})

find_path(LIBDEFLATE_INCLUDE_DIR libdeflate.h REQUIRED)
find_library(LIBDEFLATE_LIBRARY deflate REQUIRED)
add_library(libdeflate::libdeflate UNKNOWN IMPORTED)
set_target_properties(libdeflate::libdeflate PROPERTIES IMPORTED_LOCATION ${LIBDEFLATE_LIBRARY}
                      INTERFACE_INCLUDE_DIRECTORIES ${LIBDEFLATE_INCLUDE_DIR})

find_path(MINIZIP_INCLUDE_DIR minizip/unzip.h REQUIRED)
find_library(MINIZIP_LIBRARY minizip REQUIRED)
add_library(minizip::minizip UNKNOWN IMPORTED)
set_target_properties(minizip::minizip PROPERTIES IMPORTED_LOCATION ${MINIZIP_LIBRARY}
                      INTERFACE_INCLUDE_DIRECTORIES ${MINIZIP_INCLUDE_DIR})

find_path(QHULL_INCLUDE_DIR libqhull_r/libqhull_r.h REQUIRED)
find_library(QHULL_LIBRARY qhull_r REQUIRED)
add_library(qhull::qhull UNKNOWN IMPORTED)
set_target_properties(qhull::qhull PROPERTIES IMPORTED_LOCATION ${QHULL_LIBRARY}
                      INTERFACE_INCLUDE_DIRECTORIES ${QHULL_INCLUDE_DIR})

find_path(IMGUI_INCLUDE_DIR imgui.h PATH_SUFFIXES imgui REQUIRED)
find_library(IMGUI_LIBRARY imgui REQUIRED)
add_library(imgui::imgui STATIC IMPORTED)
set_target_properties(imgui::imgui PROPERTIES IMPORTED_LOCATION ${IMGUI_LIBRARY})
target_include_directories(imgui::imgui SYSTEM INTERFACE ${IMGUI_INCLUDE_DIR} ${IMGUI_INCLUDE_DIR}/backends)
target_link_libraries(imgui::imgui INTERFACE stb::stb Freetype::Freetype glfw ${CMAKE_DL_LIBS})
