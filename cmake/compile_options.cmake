# One set of options for all of our own code; third-party headers are SYSTEM and stay silent.
add_library(sonoskin_options INTERFACE)
target_include_directories(sonoskin_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(sonoskin_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror
  # x86-64-v3 (AVX2, FMA, F16C) is as fast as native for our memory-bound loops and runs on any PC since 2013.
  -march=x86-64-v3
  # Let the compiler vectorise square roots and selects; NaN and infinity keep their meaning.
  -fno-math-errno -fno-trapping-math
  # Of OpenMP the hints for vectors alone: threads are TaskPool's.
  -fopenmp-simd)
target_link_libraries(sonoskin_options INTERFACE Threads::Threads)

# A faster linker, where somebody has one.
find_program(SONOSKIN_LINKER NAMES ld.mold ld.lld)
if(SONOSKIN_LINKER)
  string(REGEX REPLACE ".*ld\\." "-fuse-ld=" linker ${SONOSKIN_LINKER})
  add_link_options(${linker})
endif()

# sonoskin_precompile(<target> [header...]): parses what nearly every file of the target includes once, a third of the time
# that it takes to compile. Files include what they use all the same: the sanitizers' builds go without.
function(sonoskin_precompile target)
  target_precompile_headers(${target} PRIVATE <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <memory>
                            <optional> <string> <vector> <fmt/format.h> <glm/glm.hpp> ${ARGN})
  # For ccache; and GCC 12 forgets of precompiled headers which are the system's, whose false alarms it then tells.
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread>)
endfunction()

set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")
