// Session files: whatever is taken is written back as the same; its recipe is read as any other, and views are numbers that
// can be drawn with.
#include "app/document/session_file.h"
#include "app/workspace/view_file.h"
#include "tests/fuzz/fuzz_input.h"

using namespace sonoskin;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(fuzz::textOf({data, size}));
  fuzz::attempt([&] {
    const SessionFile session = readSessionFile(text);
    const SessionFile again = readSessionFile(writeSessionFile(session));
    fuzz::claim(again.recipe == session.recipe && again.views == session.views &&
                    again.hasSurface == session.hasSurface && again.follows == session.follows,
                "a session repeats itself");
    fuzz::claim(recipeIn(text) == session.recipe, "a session is a recipe");
    ViewState view;
    readViews(session.views, view);
    ViewState same;
    readViews(writeViews(view), same);
    fuzz::claim(writeViews(same) == writeViews(view), "views repeat themselves");
    fuzz::claim(view.grey.width > 0 && view.camera.distance > 0 && view.slices[0].zoom > 0,
                "views can be drawn with");
    Parameters parameters;
    readRecipe(session.recipe, parameters);
  });
  return 0;
}
