// Recipes: whatever is taken is written back as the same parameters, all of them in range;
// what was erased fits its scan or is refused.
#include "core/pipeline/recipe.h"

#include "core/pipeline/check_ranges.h"
#include "tests/fuzz/fuzz_input.h"

using namespace sonoskin;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::attempt([&] {
    Parameters first, second;
    const RecipeInput input = readRecipe(std::string(fuzz::textOf({data, size})), first);
    checkRanges(first);
    const std::string written = writeRecipe(first);
    readRecipe(written, second);
    fuzz::claim(writeRecipe(second) == written, "a recipe repeats itself");
    if (input.erased.counts.empty()) return;
    Geometry scan;
    scan.dims = {5, 4, 3};
    fuzz::claim(runLengths(fromRunLengths(input.erased, scan)).dims == scan.dims,
                "what is erased fits its scan");
  });
  return 0;
}
