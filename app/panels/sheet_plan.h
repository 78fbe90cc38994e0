#pragma once

#include <string>
#include <vector>

#include "app/batch/contact_sheet.h"
#include "app/workspace/workspace.h"

namespace sonoskin::ui {

// SheetNumber: a parameter that a contact sheet may go over.
//   title  for people: "β   classification.beta"
//   value  that it has; of an iso-value that is found, the one that was found
struct SheetNumber {
  std::string name, title;
  Range<double> range;
  bool whole = false;
  double value = 0;
};

// sheetNumbers: all of them, those that are turned most first.
std::vector<SheetNumber> sheetNumbers(const Parameters& parameters, const Results& results);

// SheetRange: an axis as a person asks for it: `count` values from `from` to `to`.
//   parameter  empty: there is no such axis
struct SheetRange {
  std::string parameter;
  double from = 0, to = 0;
  int count = 5;
};

// usualRange: from half the present value to half as much again, or twice as much where equal ways are factors; so that the
// present one is in the middle.
SheetRange usualRange(const SheetNumber& number);

// axisOf: the axis; the present value is among its values where it lies between them.
SheetAxis axisOf(const SheetNumber& number, const SheetRange& range, const Parameters& parameters);

// SheetPicture: what the cells may show.
enum class SheetPicture { classified, thinned, volume, mesh, skin };

// SheetPlan: all that the dialog asks.
//   axes   the second one may be empty
//   width  of a cell, pixels; it is three quarters as high
struct SheetPlan {
  std::array<SheetRange, 2> axes;
  SheetPicture picture = SheetPicture::classified;
  Plane plane = Plane::axial;
  int width = 320;
};

// usualPlan: beta to the right, the iso-value down.
SheetPlan usualPlan(const std::vector<SheetNumber>& numbers);

// sheetView: of a cell, as the command line has it too.
ScanView sheetView(const SheetPlan& plan, const glm::dvec3& cursor);

// sheetOrder: what is to be made of the scan and parameters that are open.
//   errors  as sheetAxis() and sheetLayout()
SheetOrder sheetOrder(const SheetPlan& plan, const Workspace& workspace);

}  // namespace sonoskin::ui
