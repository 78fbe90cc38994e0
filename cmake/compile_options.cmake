# One set of options for all of our own code; third-party headers are SYSTEM and stay silent.
add_library(sonoskin_options INTERFACE)
target_include_directories(sonoskin_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(sonoskin_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror
  # x86-64-v3 (AVX2, FMA, F16C) is as fast as native for our memory-bound loops and runs on any PC since 2013.
  -march=x86-64-v3
  # Let the compiler vectorise square roots and selects; NaN and infinity keep their meaning.
  -fno-math-errno -fno-trapping-math)
target_link_libraries(sonoskin_options INTERFACE OpenMP::OpenMP_CXX Threads::Threads)
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")
