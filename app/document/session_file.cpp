#include "app/document/session_file.h"

#include <nlohmann/json.hpp>
#include <string_view>

#include "core/base/error.h"
#include "core/base/version.h"

namespace sonoskin {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kMark = "sonoskin_session";
constexpr int kFormat = 1;

// Deeper than anything that is written here; what takes a text apart, or writes it, calls itself once a level.
constexpr int kMostLevels = 12;

Json parse(const std::string& text) {
  bool tooDeep = false;
  const auto look = [&](int depth, Json::parse_event_t, const Json&) {
    return !(tooDeep |= depth > kMostLevels);
  };
  Json json = Json::parse(text, look, false);
  return tooDeep ? Json() : json;
}

bool isSession(const Json& json) { return json.is_object() && json.contains(kMark); }

// Of a session that this version of the program can read.
void requireOurFormat(const Json& session) {
  const Json& format = session[kMark];
  require(format.is_number_integer() && format == kFormat,
          "This session was saved by a newer Sonoskin; open it with that.");
}

// The object of a name, as text; empty where there is none.
std::string objectAt(const Json& json, const char* name) {
  const auto found = json.find(name);
  return found != json.end() && found->is_object() ? found->dump() : std::string();
}

std::string recipeAt(const Json& session) {
  std::string recipe = objectAt(session, "recipe");
  require(!recipe.empty(), "This session holds no recipe: it is damaged; open another one.");
  return recipe;
}

bool truthAt(const Json& json, const char* name, bool otherwise) {
  const auto found = json.find(name);
  return found != json.end() && found->is_boolean() ? found->get<bool>() : otherwise;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.back() == '\n') text.remove_suffix(1);
  return text;
}

}  // namespace

// The recipes stand as they are, with what is erased on one line.
std::string writeSessionFile(const SessionFile& session) {
  Json json;
  json[kMark] = kFormat;
  json["sonoskin"] = kVersion;
  json["volume"] = session.volume.string();
  json["surface"] = session.hasSurface;
  json["follows"] = session.follows;
  json["views"] = parse(session.views);
  std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace);
  std::string recipes = ",\n  \"recipe\": " + std::string(trimmed(session.recipe));
  if (!session.surface.empty()) recipes += ",\n  \"surfaceRecipe\": " + std::string(trimmed(session.surface));
  text.insert(text.size() - 2, recipes);
  return text + "\n";
}

SessionFile readSessionFile(const std::string& text) {
  const Json json = parse(text);
  require(isSession(json), "This is no session of Sonoskin, or it is damaged; open another one.");
  requireOurFormat(json);
  SessionFile session;
  if (const auto volume = json.find("volume"); volume != json.end() && volume->is_string())
    session.volume = volume->get<std::string>();
  session.recipe = recipeAt(json);
  session.hasSurface = truthAt(json, "surface", false);
  session.follows = truthAt(json, "follows", true);
  session.surface = objectAt(json, "surfaceRecipe");
  if (std::string views = objectAt(json, "views"); !views.empty()) session.views = std::move(views);
  return session;
}

std::string recipeIn(const std::string& text) {
  if (text.find(kMark) == std::string::npos) return text;
  const Json json = parse(text);
  if (!isSession(json)) return text;
  requireOurFormat(json);
  return recipeAt(json);
}

}  // namespace sonoskin
