// Says so where the processor lacks instructions that the rest of the program is made of, before any of that runs. This file
// alone is compiled without them.
#include <unistd.h>

namespace {

constexpr char kSentence[] =
    "sonoskin: error: This processor lacks AVX2, FMA or BMI2, which processors for PCs have had since 2013; "
    "use a newer machine, or build the program with another -march (cmake/compile_options.cmake).\n";

// Ahead of the constructors of every other file.
__attribute__((constructor(101))) void refuseOldProcessors() {
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2"))
    return;
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, kSentence, sizeof kSentence - 1);
  ::_exit(1);
}

}  // namespace
