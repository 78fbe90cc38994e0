#include "app/views/frame_share.h"

#include <algorithm>

namespace sonoskin::ui {

void shareFrame(std::span<const SharingView> views, double frameSeconds, MovingBudget& budget,
                std::span<FrameShare> shares) {
  double pictures = 0;
  for (const SharingView& view : views) pictures += view.pictureSeconds;
  budget.frame(frameSeconds, pictures);
  const bool moves = std::ranges::any_of(views, &SharingView::moving);
  const auto first = std::ranges::find_if(views, &SharingView::unfinished);
  const auto turn = first == views.end() ? 0 : std::size_t(first - views.begin());
  for (std::size_t n = 0; n < shares.size(); ++n)
    shares[n] = {budget.seconds() / double(shares.size()), n == turn, moves && shares.size() > 1};
}

}  // namespace sonoskin::ui
