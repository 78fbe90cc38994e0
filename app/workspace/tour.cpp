#include "app/workspace/tour.h"

#include <utility>

#include "app/texts/texts.h"
#include "app/workspace/workspace.h"

namespace sonoskin {
namespace {

constexpr std::array<TourCard, 5> kCards{{
    {"The scan in slices",
     "Three slices meet at the cross-hair. Drag it with the left button; the wheel goes to the next slice, "
     "the right button "
     "sets brightness and contrast.",
     Step::volume,
     {"pane.axial"}},
    {"What counts as skin",
     "v_iso is the grey value of the skin's border; α suppresses what is far from it, β smooths along "
     "the surface, "
     "γ strengthens edges. Move one: slices (key 2) and volume follow at once.",
     Step::classify,
     {"classification.isoValue", "classification.isoValue.number", "classification.gamma",
      "classification.gamma.number"}},
    {"From voxels to a surface",
     "This button, or Ctrl+Enter, fits a smooth surface through what was found. From then on it follows the "
     "parameters; "
     "Escape stops it.",
     Step::surface,
     {"surface.reconstruct"}},
    {"Skin and light",
     "The surface is shown as skin. Drag the lamp, the small disc, to move the light; drag beside it to turn "
     "the view, R "
     "looks at the face again.",
     Step::skin,
     {"pane.space"}},
    {"Keep it",
     "The mesh (Ctrl+S), a picture (F12), volumes and the recipe are saved here. Ctrl+K finds every command "
     "by its name, H "
     "shows mouse and keys.",
     Step::output,
     {"file.saveMesh", "file.savePicture"}},
}};

void show(Workspace& w, std::size_t card) {
  w.help.tour = card;
  w.step = kCards[card].step;
}

}  // namespace

std::span<const TourCard> tourCards() { return kCards; }

void startTour(Workspace& w) {
  w.help.offered = false;
  const auto start = [&w] { show(w, 0); };
  const bool isOpening = !w.session.hasScan() && w.session.activity().blocking;  // at a first start
  if (w.session.isPhantom() || isOpening) return start();
  w.confirmLoss(tr("Opening the phantom"), [&w, start] {
    w.session.openPhantom();
    start();
  });
}

void nextCard(Workspace& w) {
  const std::size_t next = *w.help.tour + 1;
  next < kCards.size() ? show(w, next) : endTour(w);
}

void previousCard(Workspace& w) { show(w, *w.help.tour - 1); }

void endTour(Workspace& w) { w.help.tour.reset(); }

bool canGoBack(const Workspace& w) { return w.help.tour.value_or(0) > 0; }

bool onTour(const Workspace& w) { return w.help.tour.has_value(); }

void offerTour(Workspace& w) { w.help.offered = !std::exchange(w.settings.tourOffered, true); }

}  // namespace sonoskin
