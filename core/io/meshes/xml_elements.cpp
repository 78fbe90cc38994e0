#include "core/io/meshes/xml_elements.h"

#include <expat.h>

#include <algorithm>
#include <exception>
#include <memory>

#include "core/base/error.h"

namespace sonoskin {
namespace {

constexpr char kSeparator = '|';  // between a namespace and a name

std::string_view localName(std::string_view name) {
  const std::size_t at = name.rfind(kSeparator);
  return at == std::string_view::npos ? name : name.substr(at + 1);
}

// Walk: expat is C, through which nothing may be thrown: what an event throws waits for its end.
struct Walk {
  XML_Parser parser;
  const XmlEvents& events;
  std::exception_ptr thrown{};

  template <class Call>
  void guard(Call&& call) try {
    if (!thrown) call();
  } catch (...) {
    thrown = std::current_exception();
    XML_StopParser(parser, XML_FALSE);
  }
};

Walk& walkOf(void* data) { return *static_cast<Walk*>(data); }

void begin(void* data, const char* name, const char** attributes) {
  walkOf(data).guard([&] { walkOf(data).events.begin(XmlElement(name, attributes)); });
}
void end(void* data, const char* name) {
  walkOf(data).guard([&] { walkOf(data).events.end(localName(name)); });
}
void text(void* data, const char* characters, int count) {
  walkOf(data).guard([&] { walkOf(data).events.text({characters, std::size_t(count)}); });
}
void prefix(void* data, const char* name, const char* space) {
  if (name && space) walkOf(data).guard([&] { walkOf(data).events.prefix(name, space); });
}
void entity(void* data, const char*, int, const char*, int, const char*, const char*, const char*,
            const char*) {
  XML_StopParser(walkOf(data).parser, XML_FALSE);
}

}  // namespace

std::string_view XmlElement::name() const { return localName(name_); }

std::optional<std::string_view> XmlElement::value(std::string_view attribute) const {
  for (const char** pair = attributes_; *pair; pair += 2)
    if (localName(pair[0]) == attribute) return pair[1];
  return {};
}

void walkXml(std::string_view xml, const XmlEvents& events, const std::filesystem::path& path) {
  constexpr std::size_t kPiece = 1u << 20;
  const std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser(
      XML_ParserCreateNS(nullptr, kSeparator), XML_ParserFree);
  if (!parser) throw std::bad_alloc();
  Walk walk{parser.get(), events};
  XML_SetUserData(parser.get(), &walk);
  XML_SetElementHandler(parser.get(), begin, end);
  XML_SetEntityDeclHandler(parser.get(), entity);
  if (events.text) XML_SetCharacterDataHandler(parser.get(), text);
  if (events.prefix) XML_SetStartNamespaceDeclHandler(parser.get(), prefix);
  bool sound = true;
  for (std::size_t at = 0; sound && at <= xml.size(); at += kPiece) {
    const std::string_view piece = xml.substr(at, kPiece);
    sound =
        XML_Parse(parser.get(), piece.data(), int(piece.size()), at + kPiece > xml.size()) == XML_STATUS_OK;
  }
  if (walk.thrown) std::rethrow_exception(walk.thrown);
  require(sound, "{} is damaged or incomplete: it is not whole XML; get a fresh copy, or save it as PLY.",
          path.string());
}

}  // namespace sonoskin
