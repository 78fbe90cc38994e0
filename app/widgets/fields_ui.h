#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>

#include "core/base/fields.h"

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

// One row: label at the left, widget at the right; the tooltip has help, symbol, range and default. A double
// click or the right button brings the default back, Ctrl+click lets one type. `id` is "group.field".
FieldsEdit editField(const std::string& id, const Field& field, double& value, double standard,
                     Range<double> range);
FieldsEdit editField(const std::string& id, const Field& field, int& value, int standard, Range<int> range);
FieldsEdit editField(const std::string& id, const Field& field, bool& value, bool standard);
FieldsEdit editField(const std::string& id, const Field& field, std::string& value,
                     const std::string& standard);
FieldsEdit editField(const std::string& id, const Field& field, std::array<int, 3>& value,
                     const std::array<int, 3>& standard, Range<int> range);
FieldsEdit editField(const std::string& id, const Field& field, std::array<double, 3>& value,
                     const std::array<double, 3>& standard, Range<double> range);
FieldsEdit editChoice(const std::string& id, const Field& field, int& value, int standard,
                      std::span<const char* const> names);

template <NamedEnum E>
FieldsEdit editField(const std::string& id, const Field& field, E& value, E standard) {
  constexpr auto names = enumNames(E{});
  int index = static_cast<int>(value);
  const FieldsEdit edit = editChoice(id, field, index, static_cast<int>(standard), names);
  value = static_cast<E>(index);
  return edit;
}

// beginFields, endFields: around the rows of a group. False where nothing is seen.
bool beginFields(const char* id);
void endFields();

// Rows: which fields of a group get a row. Without names all; else those, or all but those.
struct Rows {
  std::span<const std::string_view> names = {};
  bool except = false;
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
        const std::string id = std::string(group) + "." + std::string(field.name);
        fields(
            [&](const Field& other, const auto& standardValue, auto...) {
              if constexpr (std::is_same_v<std::decay_t<decltype(standardValue)>,
                                           std::decay_t<decltype(value)>>) {
                if (other.name == field.name) edit |= editField(id, field, value, standardValue, range...);
              }
            },
            standard);
      },
      options);
  return edit;
}

// Texts of a row, without an interface.
std::string fieldLabel(const Field& field);                  // "tangentialLength" -> "Tangential length"
std::string greekSymbol(std::string_view symbol);            // "alpha" -> "α", "v_iso" as it is
std::string fieldNumber(double value, Range<double> range);  // with the digits that the range asks for
double roundedForSlider(double value);                       // to three significant digits

}  // namespace sonoskin::ui
