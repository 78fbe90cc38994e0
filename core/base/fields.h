#pragma once

#include <array>
#include <concepts>
#include <string_view>
#include <type_traits>

namespace sonoskin {

// A parameter struct lists its members once, in a free function beside it:
//
//   template <class F, class O> requires OptionsOf<O, ClassificationOptions>
//   void fields(F&& f, O& o) {
//     f(Field{"alpha", "weight of the iso-value term", "", "α"}, o.alpha, Range{0.0, 1.0});
//
// A visitor f is called once per member with (Field, member&, Range); for bool and enum members without
// a Range. Members are int, double, bool, std::array<int or double, 3>, Places, or an enum with
// enumNames(). From that one list come sliders, command-line options, the recipe, the cache key and the
// documentation.

// Field: what a person sees of one parameter. The name is the key in recipes and on the command line.
struct Field {
  std::string_view name;
  std::string_view help;         // one sentence, no full stop
  std::string_view unit = "";    // "mm", "voxels", "dB", ...; empty for a plain number
  std::string_view symbol = "";  // the equation's symbol
};

// Range: the inclusive limits of a number; values outside are refused.
template <class T>
struct Range {
  T min, max;
  bool logarithmic = false;  // sliders move by factors
};
template <class T>
Range(T, T) -> Range<T>;
template <class T>
Range(T, T, bool) -> Range<T>;

// OptionsOf: O is Options or const Options, so that one list serves readers and writers.
template <class O, class Options>
concept OptionsOf = std::same_as<std::remove_const_t<O>, Options>;

// NamedEnum: an enum with `constexpr auto enumNames(E)` that gives the names of its values 0, 1, 2, ...
template <class E>
concept NamedEnum = std::is_enum_v<E> && requires(E e) {
  enumNames(e);
};

}  // namespace sonoskin
