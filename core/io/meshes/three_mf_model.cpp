#include "core/io/meshes/three_mf_model.h"

#include <cmath>
#include <optional>

#include "core/base/error.h"
#include "core/io/header_text.h"
#include "core/io/meshes/xml_elements.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr std::array<std::pair<std::string_view, double>, 6> kUnits{{{"micron", 0.001},
                                                                     {"millimeter", 1},
                                                                     {"centimeter", 10},
                                                                     {"inch", 25.4},
                                                                     {"foot", 304.8},
                                                                     {"meter", 1000}}};

// Extensions by a word of their namespaces, for people; those without a name change no surface.
constexpr std::array<std::pair<std::string_view, std::string_view>, 10> kExtensions{{
    {"/production/", ""},
    {"/material/", ""},
    {"/trianglesets/", ""},
    {"/beamlattice/", "beam lattices"},
    {"/slice/", "slices"},
    {"/securecontent/", "encrypted contents"},
    {"/volumetric/", "volumes"},
    {"/implicit/", "implicit functions"},
    {"/booleanoperations/", "boolean operations"},
    {"/displacement/", "displacement maps"},
}};

class Parser {
 public:
  explicit Parser(const fs::path& path) : path_(path) {}

  ThreeMfModel parse(std::string_view xml) {
    XmlEvents events;
    events.prefix = [&](std::string_view prefix, std::string_view space) {
      spaces_[std::string(prefix)] = space;
    };
    events.begin = [&](const XmlElement& element) { begin(element); };
    events.end = [&](std::string_view name) {
      if (name == "object") object_ = nullptr;
      if (name == "build") building_ = false;
    };
    walkXml(xml, events, path_);
    check(found_, "holds no model");
    return std::move(model_);
  }

 private:
  void begin(const XmlElement& e) {
    const std::string_view name = e.name();
    if (name == "vertex" && object_) {
      object_->positions.emplace_back(number(e, "x"), number(e, "y"), number(e, "z"));
    } else if (name == "triangle" && object_) {
      object_->triangles.push_back({index(e, "v1"), index(e, "v2"), index(e, "v3")});
    } else if (name == "model") {
      beginModel(e);
    } else if (name == "object") {
      beginObject(e);
    } else if (name == "component" && object_) {
      object_->components.push_back(useOf(e));
    } else if (name == "build") {
      building_ = true;
    } else if (name == "item" && building_) {
      model_.items.push_back(useOf(e));
    }
  }

  void beginModel(const XmlElement& e) {
    found_ = true;
    const std::string_view unit = e.value("unit").value_or("millimeter");
    model_.millimetres = 0;
    for (const auto& [name, millimetres] : kUnits)
      if (name == unit) model_.millimetres = millimetres;
    check(model_.millimetres > 0,
          "has a unit that is none of micron, millimeter, centimeter, inch, foot and meter");
    for (const std::string_view prefix : words(e.value("requiredextensions").value_or("")))
      requireKnown(prefix);
  }

  // By its namespace: a prefix may be any word.
  void requireKnown(std::string_view prefix) const {
    const auto space = spaces_.find(prefix);
    if (space != spaces_.end())
      for (const auto& [word, what] : kExtensions)
        if (space->second.find(word) != std::string::npos) {
          require(what.empty(),
                  "{} needs an extension of 3MF for {}, which is not read here; save it as plain triangles.",
                  path_.string(), what);
          return;
        }
    require(false, "{} needs an extension of 3MF that is not known here; save it as plain triangles.",
            path_.string());
  }

  void beginObject(const XmlElement& e) {
    const auto id = e.value("id");
    check(id && !model_.objects.contains(*id), "has objects without a number of their own");
    object_ = &model_.objects[std::string(*id)];
    object_->isBuilt = e.value("type").value_or("model") == "model" || e.value("type") == "surface";
  }

  ThreeMfUse useOf(const XmlElement& e) const {
    ThreeMfUse use;
    use.object = e.value("objectid").value_or("");
    use.part = e.value("path").value_or("");
    if (use.part.starts_with('/')) use.part.erase(0, 1);
    const auto transform = e.value("transform");
    if (!transform) return use;
    const auto values = parseNumbers<double>(*transform);
    check(values && values->size() == 12, "has a transform that is not twelve numbers");
    for (std::size_t i = 0; i < 12; ++i) {
      check(std::isfinite((*values)[i]), "has a transform that is not finite");
      use.place[int(i / 3)][int(i % 3)] = (*values)[i];  // rows of a matrix behind a row of coordinates
    }
    check(glm::determinant(glm::dmat3(use.place)) != 0, "has a transform that flattens its surface");
    return use;
  }

  float number(const XmlElement& e, std::string_view name) const {
    const auto value = parseNumber<double>(trimmed(e.value(name).value_or("")));
    check(value && std::isfinite(*value), "has a vertex that is not three numbers");
    return float(*value);
  }
  std::uint32_t index(const XmlElement& e, std::string_view name) const {
    const auto value = parseNumber<std::uint32_t>(trimmed(e.value(name).value_or("")));
    check(value.has_value(), "has a triangle without vertices");
    return *value;
  }

  void check(bool holds, const char* fault) const {
    require(holds, "{} {}; get a fresh copy, or save it as PLY.", path_.string(), fault);
  }

  const fs::path& path_;
  ThreeMfModel model_;
  std::map<std::string, std::string, std::less<>> spaces_;
  ThreeMfObject* object_ = nullptr;
  bool found_ = false, building_ = false;
};

}  // namespace

ThreeMfModel parseThreeMf(std::string_view xml, const fs::path& path) { return Parser(path).parse(xml); }

}  // namespace sonoskin
