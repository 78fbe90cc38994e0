#include "app/workspace/shown_layers.h"

#include "app/workspace/workspace.h"

namespace sonoskin {

bool isInSlices(const Workspace& w, SliceLayer layer) {
  const ViewState& view = w.view;
  if (w.settings.layout.layout == Layout::casts) return false;
  const bool over = layer == SliceLayer::thinned      ? view.surfaceVoxels
                    : layer == SliceLayer::classified ? view.classifiedTint
                                                      : false;
  return over || view.layer == layer || w.settings.layout.layout == Layout::compare;
}

}  // namespace sonoskin
