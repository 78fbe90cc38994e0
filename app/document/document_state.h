#pragma once

namespace sonoskin {

// DocumentState: what the program has to say of the document: what it is doing or, at rest, how far what is seen can be
// relied on.
//   empty      no volume is open
//   opening, working, saving   busy
//   stopped    the person ended the work before it was done: what is seen may be coarse, or older than the parameters
//   failed     the last work found nothing, or could not be done; a message said why
//   noSurface  all that was asked for is there; no surface was
//   older      the surface is older than the parameters, and does not follow them
//   live       the surface is that of the parameters, made with short cuts while they moved
//   current    everything is what the parameters lead to
enum class DocumentState {
  empty,
  opening,
  working,
  saving,
  stopped,
  failed,
  noSurface,
  older,
  live,
  current
};

// DocumentFacts: what the state follows from.
struct DocumentFacts {
  bool hasScan = false;
  bool opening = false, working = false, saving = false;  // in the background
  bool stopped = false, failed = false;                   // how the last work ended
  bool hasMesh = false, meshIsCurrent = false, meshIsFinal = false;
};

// stateOf: the one state; what is going on comes before how something ended, and that before what is there.
DocumentState stateOf(const DocumentFacts& facts);

// stateText: a word or two for people.
const char* stateText(DocumentState state);

}  // namespace sonoskin
