#pragma once
/// Keys that are given and change nothing: a user must be told of them.

#include "app/input/keys/study_keys.hpp"
#include "app/input/prepared_study.hpp"
#include "app/input/study_reading.hpp"
#include "app/input/verb.hpp"

#include <string>

namespace app {

struct StudyFile;
struct UqInput;

/// Whether the verb reads the key at all.
[[nodiscard]] bool reads(const Verb& verb, const Key& key);

/// One line for each reason why keys that are given have no effect on what the verb computes:
/// "note: uq.kernel, uq.correlation_length: no effect, because uq.spatial is not correlated".
/// Empty if every given key has an effect. Sections that the verb does not read are passed
/// over, since one study file serves several verbs.
[[nodiscard]] std::string effect_notes(const Study& study, const Verb& verb);

/// Cost of making the blocks, where that is much: a line for people; else nothing.
/// @param purpose of a drawing nothing is refused
/// @throws ConfigError where this machine has not the memory
[[nodiscard]] std::string cost_note(const PreparedStudy& ready, Purpose purpose);

/// The same of one push, where that takes half a minute or more.
[[nodiscard]] std::string push_note(const PreparedStudy& ready);

/// @throws ConfigError where the study names one wall (uq.drawn)
void refuse_drawn(const UqInput& uq, const StudyFile& source);

/// All notes on a study before it is run, for people: these, and what was closed, simplified or
/// ignored of a drawing.
/// @throws ConfigError where the study names one wall (uq.drawn) and the verb is not push, and
/// where it asks for both directions and the verb pushes each wall once
/// @param verb that runs it; nullptr, as of other programs: nothing
[[nodiscard]] std::string study_notes(const PreparedStudy& ready, const Verb* verb);

} // namespace app
