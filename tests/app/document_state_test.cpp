#include "app/document/document_state.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace sonoskin {
namespace {

using enum DocumentState;

struct Row {
  DocumentFacts facts;
  DocumentState state;
};

DocumentFacts mesh(bool current, bool final) {
  return {.hasScan = true, .hasMesh = true, .meshIsCurrent = current, .meshIsFinal = final};
}

DocumentFacts with(DocumentFacts facts, bool DocumentFacts::*fact) {
  facts.*fact = true;
  return facts;
}

TEST(DocumentState, FollowsFromTheFactsAsTheTableSays) {
  const DocumentFacts none{}, scan{.hasScan = true}, done = mesh(true, true);
  const Row table[] = {
      {none, empty},
      {with(none, &DocumentFacts::opening), opening},
      {scan, noSurface},
      {mesh(true, true), current},
      {mesh(true, false), live},
      {mesh(false, true), older},
      {mesh(false, false), older},
      {with(scan, &DocumentFacts::working), working},
      {with(done, &DocumentFacts::opening), opening},
      {with(done, &DocumentFacts::working), working},
      {with(done, &DocumentFacts::saving), saving},
      {with(done, &DocumentFacts::stopped), stopped},
      {with(scan, &DocumentFacts::stopped), stopped},
      {with(done, &DocumentFacts::failed), failed},
      {with(scan, &DocumentFacts::failed), failed},
      {with(with(done, &DocumentFacts::stopped), &DocumentFacts::working), working},
      {with(with(done, &DocumentFacts::working), &DocumentFacts::opening), opening},
      {with(none, &DocumentFacts::stopped), empty},
  };
  for (const Row& row : table) EXPECT_EQ(stateOf(row.facts), row.state) << &row - table;
}

TEST(DocumentState, EachHasWordsOfItsOwn) {
  std::set<std::string> texts;
  for (int s = 0; s <= int(current); ++s) texts.insert(stateText(DocumentState(s)));
  EXPECT_EQ(texts.size(), std::size_t(current) + 1);
  EXPECT_STREQ(stateText(empty), "Waiting for a volume");
  EXPECT_STREQ(stateText(failed), "Failed");
  EXPECT_STREQ(stateText(current), "Up to date");
}

}  // namespace
}  // namespace sonoskin
