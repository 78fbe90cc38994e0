#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/batch/scan_view.h"
#include "app/batch/sheet_axis.h"
#include "core/io/image.h"

namespace sonoskin {

// SheetOrder: a contact sheet before it is made [thesis, figure 4.3]: the same picture for each value of one parameter, or each
// pair of values of two.
//   axes  one or two: the first goes to the right, the second down; one alone goes on in further rows
//   view  of a cell, its picture's size included
struct SheetOrder {
  Scan scan;
  Parameters parameters;
  std::vector<SheetAxis> axes;
  ScanView view;
};

// SheetCell: one picture of it.
//   values   which value of each axis
//   failure  why there is no picture: a sentence
//   current  it has the parameters' own values
struct SheetCell {
  std::vector<std::size_t> values;
  std::string text, failure;
  bool current = false;
  Image picture{};
};

// SheetLayout: where the cells lie in the sheet, pixels, from its upper left corner.
struct SheetLayout {
  glm::ivec2 grid{1}, cell{320, 240};
  int text = 14;  // height of the letters

  glm::ivec2 corner(std::size_t cell) const;
  glm::ivec2 size() const;
  // at: the cell at a place of the sheet, its label included; none between them.
  std::optional<std::size_t> at(glm::vec2 place) const;
};

// ContactSheet: its cells, row by row, and what the stages of the pipeline took for all of them; a stage whose result another
// cell had made counts once.
struct ContactSheet {
  SheetLayout layout;
  std::vector<SheetCell> cells;
  std::vector<StageReport> stages;
};

// sheetLayout: of what is asked for.
//   errors  Error (usage): no axis or more than two, the same twice; the sheet would be larger than 16,384 pixels a side
SheetLayout sheetLayout(const std::vector<SheetAxis>& axes, glm::ivec2 cell);

// makeSheet: all its pictures, by one pipeline, so that each stage is done once for all cells that agree so far. A combination
// in which nothing is found leaves its cell without a picture.
//   context     released after each picture
//   cellBegins  called with how far it is, for people: "3 of 9: β 1   γ 2"
//   errors      as sheetLayout; Error: nothing is found in any cell; Cancelled
ContactSheet makeSheet(gl::Context& context, const SheetOrder& order, const Progress& progress = {},
                       const std::function<void(const std::string&)>& cellBegins = {});

// pictureOfSheet: the cells with their labels; the current one is framed.
Image pictureOfSheet(const ContactSheet& sheet);

}  // namespace sonoskin
