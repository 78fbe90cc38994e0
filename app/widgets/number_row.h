#pragma once

#include <string>

#include "app/widgets/fields_ui.h"

namespace sonoskin::ui {

// NumberTrack: the widget of a number: a track whose grab is dragged, and beside it the number, which a click turns into a
// field to type in.
//   min, max     of the value
//   logarithmic  equal ways on the track are equal factors; needs min > 0
//   whole        the value is an integer
//   shown        the number for people
//   unit         after it, fainter; may be empty
//   grab         where the grab stands
struct NumberTrack {
  double min = 0, max = 1;
  bool logarithmic = false, whole = false;
  std::string shown, unit;
  double grab = 0;
};

// editTrack: between openRow() and closeRow().
//   facts   for the tooltip of the track
//   asked   set where the default was asked for
FieldsEdit editTrack(const FieldRow& row, double& value, const NumberTrack& track, const std::string& facts,
                     bool& asked);

// numberTyped: what somebody typed, with a point or a comma and perhaps a unit behind; empty where it is no number.
std::optional<double> numberTyped(std::string text);

}  // namespace sonoskin::ui
