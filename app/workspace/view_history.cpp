#include "app/workspace/view_history.h"

#include <utility>

#include "app/workspace/workspace.h"

namespace sonoskin {
namespace {

ViewEdits editsOf(const ViewState& view) {
  const VolumeShow& volume = view.volume;
  return {view.measures, view.clip, {volume.colours, volume.own, volume.changed}};
}

void show(const ViewEdits& edits, ViewState& view) {
  VolumeShow& volume = view.volume;
  if (!(VolumeColours{volume.colours, volume.own, volume.changed} == edits.colours)) volume.selected = -1;
  view.measures = edits.measures;
  view.clip = edits.clip;
  volume.colours = edits.colours.name;
  volume.own = edits.colours.own;
  volume.changed = edits.colours.changed;
}

}  // namespace

void noteViewEdits(Workspace& w, bool held) {
  if (!w.session.hasScan()) return;
  if (!(w.session.viewEdits() == w.notedEdits)) {
    w.notedEdits = w.session.viewEdits();
    return show(w.notedEdits, w.view);
  }
  if (held) return;
  ViewEdits edits = editsOf(w.view);
  if (edits == w.notedEdits) return;
  w.session.editViews(edits);
  w.notedEdits = std::move(edits);
}

void beginViewEdits(Workspace& w) {
  w.notedEdits = editsOf(w.view);
  w.session.beginViews(w.notedEdits);
}

}  // namespace sonoskin
