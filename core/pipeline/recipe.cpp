#include "core/pipeline/recipe.h"

#include <fmt/format.h>

#include <climits>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/base/error.h"
#include "core/base/shown_text.h"
#include "core/base/version.h"
#include "core/pipeline/check_ranges.h"

namespace sonoskin {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void refuse(const std::string& sentence) { throw Error("recipe: " + sentence); }

template <class T>
Json toJson(const T& value) {
  if constexpr (NamedEnum<T>) {
    return enumNames(value)[std::size_t(value)];
  } else {
    return value;
  }
}

template <class T>
constexpr const char* kindName() {
  if constexpr (std::is_same_v<T, bool>) return "true or false";
  if constexpr (std::is_same_v<T, int>) return "a whole number";
  if constexpr (std::is_same_v<T, double>) return "a number";
  if constexpr (std::is_same_v<T, std::array<int, 3>>) return "three whole numbers in a list";
  return "three numbers in a list";
}

// Whether a whole number is one of an int, and not one that would wrap.
bool isInt(const Json& json) {
  if (json.is_number_unsigned()) return json.get<std::uint64_t>() <= std::uint64_t(INT_MAX);
  return json.get<std::int64_t>() >= INT_MIN;
}

// Whether the JSON value is of T's kind; JSON's own conversions would take 1.5 for an int.
template <class T>
bool fits(const Json& json) {
  if constexpr (std::is_same_v<T, bool>) return json.is_boolean();
  if constexpr (std::is_same_v<T, int>) return json.is_number_integer() && isInt(json);
  if constexpr (std::is_same_v<T, double>) return json.is_number();
  return false;
}

template <class T>
void fromJson(const Json& json, const std::string& name, T& value) {
  if constexpr (NamedEnum<T>) {
    const auto names = enumNames(T{});
    for (std::size_t i = 0; i < names.size(); ++i)
      if (json.is_string() && json.get<std::string>() == names[i]) {
        value = T(i);
        return;
      }
    refuse(fmt::format("{} must be one of \"{}\"", name, fmt::join(names, "\", \"")));
  } else if constexpr (std::is_same_v<T, Places>) {
    if (!json.is_array()) refuse(fmt::format("{} must be a list of places, three numbers each", name));
    value.assign(json.size(), {});
    for (std::size_t i = 0; i < json.size(); ++i) fromJson(json[i], fmt::format("{}[{}]", name, i), value[i]);
  } else if constexpr (requires { value.size(); }) {
    using Element = typename T::value_type;
    if (!json.is_array() || json.size() != value.size())
      refuse(fmt::format("{} must be {}", name, kindName<T>()));
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (!fits<Element>(json[i])) refuse(fmt::format("{} must be {}", name, kindName<T>()));
      value[i] = json[i].get<Element>();
    }
  } else {
    if (!fits<T>(json)) refuse(fmt::format("{} must be {}", name, kindName<T>()));
    value = json.get<T>();
  }
}

// Reads one group's object; every key must be a field.
template <class Options>
void readGroup(const Json& object, const std::string& group, Options& options) {
  if (!object.is_object()) refuse(fmt::format("\"{}\" must be an object of fields", group));
  for (const auto& [key, value] : object.items()) {
    bool known = false;
    fields(
        [&, k = std::string_view(key), &v = value](const Field& field, auto& member, auto...) {
          if (field.name != k) return;
          known = true;
          fromJson(v, fmt::format("{}.{}", group, k), member);
        },
        options);
    if (!known) refuse(fmt::format("there is no parameter {}.{}", group, shownText(key)));
  }
}

Json parse(const std::string& text) {
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& e) {
    refuse(fmt::format("not valid JSON near byte {}", e.byte));
  } catch (const Json::exception&) {  // a number beyond all that there are
    refuse("not valid JSON: a number is too large");
  }
}

// Runs beyond which a recipe would be longer than what is read.
constexpr std::size_t kMostRuns = 1'000'000;

Json toJson(const RunLengths& runs) {
  if (runs.counts.size() > kMostRuns)
    throw Error(
        "What is erased is too ragged for a recipe: save it as a volume, and name that with --erase.");
  return {{"dims", {runs.dims.x, runs.dims.y, runs.dims.z}}, {"counts", runs.counts}};
}

RunLengths readErased(const Json& json) {
  std::array<int, 3> dims{};
  const bool whole = json.is_object() && json.contains("dims") && json.contains("counts") &&
                     json["counts"].is_array() && json["counts"].size() <= kMostRuns;
  if (!whole) refuse("\"erased\" must hold \"dims\" and a list of \"counts\"");
  fromJson(json["dims"], "erased.dims", dims);
  RunLengths runs{{dims[0], dims[1], dims[2]}, {}};
  for (const Json& count : json["counts"]) {
    if (!count.is_number_unsigned()) refuse("erased.counts must hold whole numbers that are not negative");
    runs.counts.push_back(count.get<std::size_t>());
  }
  return runs;
}

}  // namespace

std::string writeRecipe(const Parameters& parameters, const Key& input, const Volume<std::uint8_t>* erased) {
  Json json;
  json["sonoskin"] = kVersion;
  if (input) json["input"] = input.hex();
  groups(
      [&](const Group& group, const auto& options) {
        Json& object = json[std::string(group.name)] = Json::object();
        fields([&](const Field& field, const auto& member,
                   auto...) { object[std::string(field.name)] = toJson(member); },
               options);
      },
      parameters);
  std::string text = json.dump(2);
  // The runs stand on one line: there are thousands of them.
  if (erased) text.insert(text.size() - 2, ",\n  \"erased\": " + toJson(runLengths(*erased)).dump());
  return text + "\n";
}

RecipeInput readRecipe(const std::string& text, Parameters& parameters) {
  const Json json = parse(text);
  if (!json.is_object()) refuse("it must be a JSON object of parameter groups");
  Parameters read = parameters;
  RecipeInput input;
  for (const auto& [key, value] : json.items()) {
    if (key == "sonoskin") continue;
    if (key == "input" && value.is_string()) input.key = value.get<std::string>();
    if (key == "erased") input.erased = readErased(value);
    if (key == "input" || key == "erased") continue;
    bool known = false;
    groups(
        [&, k = std::string_view(key), &v = value](const Group& group, auto& options) {
          if (group.name != k) return;
          known = true;
          readGroup(v, std::string(k), options);
        },
        read);
    if (!known) refuse(fmt::format("there is no group of parameters \"{}\"", shownText(key)));
  }
  checkRanges(read);
  parameters = read;
  return input;
}

}  // namespace sonoskin
