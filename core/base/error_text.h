#pragma once

#include <exception>
#include <string>

namespace sonoskin {

// errorText: what a person is told of an error that ended a task: the sentence of an Error, as asSentence has it; that
// memory is short; else the library's own words, as what they are.
std::string errorText(const std::exception& error);

// asSentence: a text as it stands before a person: with a full stop, and with a capital letter where it begins with a word
// that sentences begin with, and not with the name of a parameter, an option or a file.
std::string asSentence(std::string text);

// systemCause: why the system refused something, and what helps: "No space left on device; make room or choose another
// place". Without a full stop.
//   input  number  errno's
std::string systemCause(int number);

}  // namespace sonoskin
