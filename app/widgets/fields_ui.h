#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/fields.h"
#include "core/base/places.h"

namespace sonoskin::ui {

// FieldsEdit: what a person did to a parameter in this frame.
struct FieldsEdit {
  bool changed = false;   // it has another value
  bool finished = false;  // it was let go: a step for undo
  FieldsEdit& operator|=(FieldsEdit other) {
    changed |= other.changed;
    finished |= other.finished;
    return *this;
  }
};

// RowText: what a row says beyond its field.
struct RowText {
  std::string label = {};           // instead of the field's own name
  std::string shown = {};           // instead of the number and its unit
  std::optional<double> grab = {};  // where the slider's grab stands instead of at the value
  std::string found = {};           // how the value was found, for the tooltip
  std::string unused = {};          // why the parameter has no effect just now; the row is grey then
};

// FieldRow: the parameter of one row. `id` is "group.field".
struct FieldRow {
  std::string id;
  Field field;
  RowText text = {};
};

// One row: label and symbol at the left, then the widget, then the button that brings the default back. Numbers have a track
// and the number beside it, which a click, or Ctrl+click on the track, lets one type. The tooltip has help, equation, symbol,
// range and default; a double click or the right button brings the default back, too.
FieldsEdit editField(const FieldRow& row, double& value, double standard, Range<double> range);
FieldsEdit editField(const FieldRow& row, int& value, int standard, Range<int> range);
FieldsEdit editField(const FieldRow& row, bool& value, bool standard);
FieldsEdit editField(const FieldRow& row, std::string& value, const std::string& standard);
FieldsEdit editField(const FieldRow& row, std::array<int, 3>& value, const std::array<int, 3>& standard,
                     Range<int> range);
FieldsEdit editField(const FieldRow& row, std::array<double, 3>& value, const std::array<double, 3>& standard,
                     Range<double> range);
// Places are made elsewhere: the row tells how many there are, and a button forgets them.
FieldsEdit editField(const FieldRow& row, Places& value, const Places& standard, Range<double> range);
FieldsEdit editChoice(const FieldRow& row, int& value, int standard, std::span<const char* const> names);

template <NamedEnum E>
FieldsEdit editField(const FieldRow& row, E& value, E standard) {
  constexpr auto names = enumNames(E{});
  int index = static_cast<int>(value);
  const FieldsEdit edit = editChoice(row, index, static_cast<int>(standard), names);
  value = static_cast<E>(index);
  return edit;
}

// beginRow: the label of a row of one's own, with its symbol; the widget comes next, as wide as those
// of other rows.
void beginRow(const std::string& label, const std::string& symbol = {});

// beginFields, endFields: around the rows of a group. False where nothing is seen.
bool beginFields(const char* id);
void endFields();

// Rows: which fields of a group get a row, and what the rows say. Without names all; else those, or all but those.
struct Rows {
  std::span<const std::string_view> names = {};
  bool except = false;
  std::function<RowText(std::string_view name)> text = {};
  bool contain(std::string_view name) const {
    return names.empty() || (std::find(names.begin(), names.end(), name) != names.end()) != except;
  }
};

// editFields: a row for every field of an options struct, with the defaults of a fresh one.
template <class Options>
FieldsEdit editFields(std::string_view group, Options& options, const Rows& rows = {}) {
  FieldsEdit edit;
  const Options standard;
  fields(
      [&](const Field& field, auto& value, auto... range) {
        if (!rows.contain(field.name)) return;
        const FieldRow row{std::string(group) + "." + std::string(field.name), field,
                           rows.text ? rows.text(field.name) : RowText{}};
        fields(
            [&](const Field& other, const auto& standardValue, auto...) {
              if constexpr (std::is_same_v<std::decay_t<decltype(standardValue)>,
                                           std::decay_t<decltype(value)>>) {
                if (other.name == field.name) edit |= editField(row, value, standardValue, range...);
              }
            },
            standard);
      },
      options);
  return edit;
}

// Texts of a row, without an interface.
std::string fieldName(const Field& field);         // "tangentialLength" -> "Tangential length"
std::string fieldLabel(const Field& field);        // the same in the window's language
std::string presetTitle(std::string_view name);    // of a preset: "thesis-baby-1" -> "Thesis baby 1"
std::string greekSymbol(std::string_view symbol);  // "alpha" -> "α", "v_iso" as it is
std::string fieldNumber(double value, Range<double> range);  // with the digits that the range asks for
double roundedForSlider(double value);                       // to three significant digits

}  // namespace sonoskin::ui
