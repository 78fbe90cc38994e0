#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "core/base/fields.h"

namespace sonoskin::view_json {

// JSON of whatever a list of fields may hold (app/workspace/view_fields.h), and the way back, which takes nothing on trust.

using Json = nlohmann::json;

inline constexpr std::size_t kMostElements = 10'000;  // of a list
inline constexpr double kFar = 1e6;                   // of numbers without a range: mm from the origin

template <class T>
inline constexpr bool isVector = false;
template <glm::length_t L, class T, glm::qualifier Q>
inline constexpr bool isVector<glm::vec<L, T, Q>> = true;
template <class T>
inline constexpr bool isMatrix = false;
template <glm::length_t C, glm::length_t R, class T, glm::qualifier Q>
inline constexpr bool isMatrix<glm::mat<C, R, T, Q>> = true;
template <class T>
inline constexpr bool isOptional = false;
template <class T>
inline constexpr bool isOptional<std::optional<T>> = true;
template <class T>
inline constexpr bool isArray = false;
template <class T, std::size_t N>
inline constexpr bool isArray<std::array<T, N>> = true;
template <class T>
inline constexpr bool isList = false;
template <class T>
inline constexpr bool isList<std::vector<T>> = true;

inline std::string nameOf(const char* name) { return name; }
inline std::string nameOf(const Field& field) { return std::string(field.name); }  // of parameters

// write: null where there is nothing, or an enum's value has no name.
template <class T>
Json write(const T& value) {
  if constexpr (std::is_arithmetic_v<T>) {
    return value;
  } else if constexpr (std::is_same_v<T, std::string>) {
    return value;
  } else if constexpr (NamedEnum<T>) {
    const auto names = enumNames(value);
    return std::size_t(value) < names.size() ? Json(names[std::size_t(value)]) : Json();
  } else if constexpr (isVector<T>) {
    Json list = Json::array();
    for (int i = 0; i < T::length(); ++i) list.push_back(value[i]);
    return list;
  } else if constexpr (isMatrix<T>) {
    Json columns = Json::array();
    for (int i = 0; i < T::length(); ++i) columns.push_back(write(value[i]));
    return columns;
  } else if constexpr (isOptional<T>) {
    return value ? write(*value) : Json();
  } else if constexpr (isArray<T> || isList<T>) {
    Json list = Json::array();
    for (const auto& element : value) list.push_back(write(element));
    return list;
  } else {
    Json object = Json::object();
    fields([&](const auto& name, const auto& member, auto...) { object[nameOf(name)] = write(member); },
           value);
    return object;
  }
}

template <class T>
void read(const Json& json, T& value, double least = -kFar, double most = kFar);

template <class T>
void readNumber(const Json& json, T& value, double least, double most) {
  if (!json.is_number()) return;
  const double number = json.get<double>();
  if constexpr (std::is_unsigned_v<T>) least = std::max(least, 0.0);
  if (std::isfinite(number)) value = T(std::clamp(number, least, most));
}

template <class T>
void readElements(const Json& json, T& value, double least, double most) {
  for (std::size_t i = 0; i < value.size(); ++i) read(json[i], value[i], least, most);
}

// The fields of a struct, each within its own range.
template <class T>
void readFields(const Json& json, T& value) {
  const auto readMember = [&](const auto& name, auto& member, auto... range) {
    const auto found = json.find(nameOf(name));
    if (found == json.end()) return;
    if constexpr (sizeof...(range) == 0) {
      read(*found, member);
    } else {
      (read(*found, member, double(range.min), double(range.max)), ...);
    }
  };
  if (json.is_object()) fields(readMember, value);
}

// read: leaves the value where the JSON is of another kind.
template <class T>
void read(const Json& json, T& value, double least, double most) {
  if constexpr (std::is_same_v<T, bool>) {
    if (json.is_boolean()) value = json.get<bool>();
  } else if constexpr (std::is_arithmetic_v<T>) {
    readNumber(json, value, least, most);
  } else if constexpr (std::is_same_v<T, std::string>) {
    if (json.is_string()) value = json.get<std::string>();
  } else if constexpr (NamedEnum<T>) {
    const auto names = enumNames(T{});
    for (std::size_t i = 0; i < names.size(); ++i)
      if (json == names[i]) value = T(i);
  } else if constexpr (isVector<T>) {
    if (!json.is_array() || json.size() != std::size_t(T::length())) return;
    for (int i = 0; i < T::length(); ++i) readNumber(json[std::size_t(i)], value[i], least, most);
  } else if constexpr (isMatrix<T>) {
    if (!json.is_array() || json.size() != std::size_t(T::length())) return;
    for (int i = 0; i < T::length(); ++i) read(json[std::size_t(i)], value[i], least, most);
  } else if constexpr (isOptional<T>) {
    typename T::value_type element{};
    if (!json.is_null()) read(json, element, least, most);
    value = json.is_null() ? T() : T(element);
  } else if constexpr (isArray<T>) {
    if (json.is_array() && json.size() == value.size()) readElements(json, value, least, most);
  } else if constexpr (isList<T>) {
    if (!json.is_array() || json.size() > kMostElements) return;
    value.assign(json.size(), {});
    readElements(json, value, least, most);
  } else {
    readFields(json, value);
  }
}

}  // namespace sonoskin::view_json
