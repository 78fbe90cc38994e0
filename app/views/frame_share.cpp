#include "app/views/frame_share.h"

#include <algorithm>

namespace sonoskin::ui {

namespace {

// The next of the views that do not move by themselves.
std::size_t nextMoved(std::span<const SharingView> views, std::size_t turn) {
  for (std::size_t n = 0; n < views.size(); ++n)
    if (turn = (turn + 1) % views.size(); !views[turn].moving) break;
  return turn;
}

}  // namespace

void shareFrame(std::span<const SharingView> views, double frameSeconds, SharedTime& shared,
                std::span<FrameShare> shares) {
  double pictures = 0, drafts = 0;
  for (const SharingView& view : views) pictures += view.pictureSeconds, drafts += view.draftSeconds;
  shared.budget.frame(frameSeconds, pictures);
  const bool moves = shares.size() > 1 && std::ranges::any_of(views, &SharingView::moving);
  const bool inTurn = moves && drafts > 1 / MovingBudget::kFrames;
  if (inTurn) shared.turn = nextMoved(views, shared.turn);
  const auto first = std::ranges::find_if(views, &SharingView::unfinished);
  const auto turn = first == views.end() ? 0 : std::size_t(first - views.begin());
  for (std::size_t n = 0; n < shares.size(); ++n)
    shares[n] = {shared.budget.seconds() / double(shares.size()), n == turn, moves,
                 !inTurn || views[n].moving || n == shared.turn};
}

}  // namespace sonoskin::ui
