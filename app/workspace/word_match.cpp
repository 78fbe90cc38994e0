#include "app/workspace/word_match.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace sonoskin {
namespace {

constexpr int kJumpCost = 4;  // to another word, as much as four words that are passed over

// Letters beyond ASCII are letters.
bool isLetter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || static_cast<signed char>(c) < 0;
}

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

std::vector<std::size_t> wordStarts(std::string_view text) {
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (isLetter(text[i]) && (i == 0 || !isLetter(text[i - 1]))) starts.push_back(i);
  return starts;
}

std::vector<std::string_view> wordsOf(std::string_view text) {
  std::vector<std::string_view> words;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (end > 0) words.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return words;
}

// A text as one word after the other is looked for in it.
struct Searched {
  std::string_view text;
  std::vector<std::size_t> starts;

  // The least cost of the rest of a word, whose letters go on at `at` or with the beginning of a later word.
  std::optional<int> rest(std::string_view word, std::size_t at) const {
    if (word.empty()) return 0;
    std::optional<int> least;
    const auto take = [&](std::optional<int> cost, int more) {
      if (cost && (!least || *cost + more < *least)) least = *cost + more;
    };
    if (at < text.size() && lower(text[at]) == lower(word[0])) take(rest(word.substr(1), at + 1), 0);
    for (const std::size_t start : starts)
      if (start > at && lower(text[start]) == lower(word[0]))
        take(rest(word.substr(1), start + 1), kJumpCost);
    return least;
  }
  std::optional<int> cost(std::string_view word) const {
    std::optional<int> least;
    for (std::size_t i = 0; i < starts.size(); ++i) {
      if (lower(text[starts[i]]) != lower(word[0])) continue;
      const std::optional<int> after = rest(word.substr(1), starts[i] + 1);
      if (after && (!least || *after + int(i) < *least)) least = *after + int(i);
    }
    return least;
  }
};

}  // namespace

std::optional<int> misfit(std::string_view words, std::string_view text) {
  const Searched searched{text, wordStarts(text)};
  int sum = 0;
  for (const std::string_view word : wordsOf(words)) {
    const std::optional<int> cost = searched.cost(word);
    if (!cost) return {};
    sum += *cost;
  }
  return sum;
}

}  // namespace sonoskin
