#pragma once
/// A study read from its file, and written down again.

#include "app/input/study/study_file.hpp"

#include <span>
#include <string>

namespace app {

struct Study;

/// The reason for which a study is read. A drawing needs no load: a height that does not fit
/// the wall is told, not refused.
enum class Purpose { push, drawing };

/// Reads and checks values and the outlines of a drawing; runs no solver, grows no rubble:
/// prepare() does (app/input/prepared_study.hpp).
/// @throws ConfigError at the first key that is unknown, missing, malformed, out of range or at
/// odds with another
[[nodiscard]] Study read_study(const StudyFile& file, Purpose purpose = Purpose::push);
/// The same of a file of this name, with values of --set in place of its own.
[[nodiscard]] Study read_study(const std::string& path, std::span<const std::string> overrides,
                               Purpose purpose = Purpose::push);

/// Whether a file has a section [model]: a study of another program.
[[nodiscard]] bool is_program_study(const StudyFile& file);

/// A study of another program: `program`, `uq`, `reliability`, and `random` with its
/// [variables].
/// @throws ConfigError as read_study
[[nodiscard]] Study read_program_study(const StudyFile& file);

/// The study in full, as a study file that reads back to the same study; values that were not
/// given are marked "# default", values given on the command line "# --set".
[[nodiscard]] std::string effective_configuration(const Study& study);

} // namespace app
