// Sentences that were made elsewhere are found by the words around what stands in their places.

#include <cctype>
#include <optional>
#include <vector>

#include "app/texts/text_table.h"
#include "app/texts/texts.h"

namespace sonoskin {
namespace {

// What a text has before, between and behind its places: one piece more than there are places.
std::vector<std::string_view> piecesOf(std::string_view text) {
  std::vector<std::string_view> pieces;
  for (std::size_t open = text.find('{'); open != text.npos; open = text.find('{')) {
    const std::size_t close = std::min(text.find('}', open), text.size() - 1);
    pieces.push_back(text.substr(0, open));
    text.remove_prefix(close + 1);
  }
  pieces.push_back(text);
  return pieces;
}

// What stands in the places of a sentence; nothing where its words are others.
std::optional<std::vector<std::string_view>> standingIn(std::string_view sentence,
                                                        const std::vector<std::string_view>& pieces) {
  if (!sentence.starts_with(pieces.front())) return {};
  sentence.remove_prefix(pieces.front().size());
  std::vector<std::string_view> standing;
  for (std::size_t n = 1; n < pieces.size(); ++n) {
    const bool last = n + 1 == pieces.size();
    const std::size_t at = last ? sentence.rfind(pieces[n]) : sentence.find(pieces[n]);
    if (at == sentence.npos || (last && at + pieces[n].size() != sentence.size())) return {};
    standing.push_back(sentence.substr(0, at));
    sentence.remove_prefix(at + pieces[n].size());
  }
  if (!sentence.empty()) return {};
  return standing;
}

// What stands in a place may be words, but names of one word are names.
std::string saidOf(std::string_view standing) {
  return standing.find(' ') == standing.npos ? std::string(standing) : trSentence(standing);
}

std::string filled(std::string_view text, const std::vector<std::string_view>& standing) {
  const std::vector<std::string_view> pieces = piecesOf(text);
  std::string result(pieces.front());
  for (std::size_t n = 1; n < pieces.size(); ++n) {
    if (n <= standing.size()) result += saidOf(standing[n - 1]);
    result += pieces[n];
  }
  return result;
}

// A place alone would fit any sentence.
bool hasWords(const std::vector<std::string_view>& pieces) {
  std::size_t letters = 0;
  for (const std::string_view piece : pieces)
    for (const char c : piece) letters += std::isalpha(static_cast<unsigned char>(c)) ? 1 : 0;
  return letters >= 5;
}

std::optional<std::string> translated(std::string_view sentence) {
  for (const std::span<const Text> table : textTables()) {
    for (const Text& text : table) {
      const std::vector<std::string_view> pieces = piecesOf(text.english);
      if (pieces.size() > 1 && !hasWords(pieces)) continue;
      if (const auto standing = standingIn(sentence, pieces))
        return filled(usedLanguage() == Language::german ? text.german : text.french, *standing);
    }
  }
  return {};
}

}  // namespace

std::string trSentence(std::string_view english) {
  if (usedLanguage() == Language::english || english.empty()) return std::string(english);
  if (std::string whole = tr(english); whole != english) return whole;
  if (const auto found = translated(english)) return *found;
  if (!english.ends_with('.')) return std::string(english);
  std::string bare(english.substr(0, english.size() - 1));
  bare[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(bare[0])));
  if (const auto found = translated(bare)) return capitalised(*found) + ".";
  return std::string(english);
}

}  // namespace sonoskin
