#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string_view>

namespace sonoskin {

// XmlElement: the start of an element while it is looked at: its name and attributes without their namespaces, entities
// resolved.
class XmlElement {
 public:
  XmlElement(const char* name, const char** attributes) : name_(name), attributes_(attributes) {}
  std::string_view name() const;
  // value: of an attribute; nothing where it has none of that name.
  std::optional<std::string_view> value(std::string_view attribute) const;

 private:
  const char* name_;
  const char** attributes_;
};

// XmlEvents: what is called while a text is walked through. What one throws ends the walk and comes out of it.
//   prefix  a namespace is given a prefix, as far as the extensions of a format go by these
struct XmlEvents {
  std::function<void(const XmlElement&)> begin;
  std::function<void(std::string_view name)> end;
  std::function<void(std::string_view text)> text{};
  std::function<void(std::string_view prefix, std::string_view space)> prefix{};
};

// walkXml: goes through a text in XML with expat. Definitions of entities are refused, so nothing grows or leads elsewhere.
//   errors  Error: no XML; those of the events
void walkXml(std::string_view xml, const XmlEvents& events, const std::filesystem::path& path);

}  // namespace sonoskin
