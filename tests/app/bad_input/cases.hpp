#pragma once
/// Mistakes that people make, and the exact message that each earns. Read by the tests of the
/// library and of the program.

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bad_input {

/// A complete study of two stress levels, without defaults; every case spoils one line of it.
extern const std::string_view kGoodStudy;

/// A study file with a fault.
struct BadStudy {
    std::string_view fault;
    std::string_view line;    ///< of kGoodStudy; empty: the whole file
    std::string_view instead; ///< what stands in its place
    std::string_view message; ///< for a file named study.ini
};

/// A command line with a fault, in a directory that holds kGoodStudy as study.ini.
struct BadCommand {
    std::string_view fault;
    std::vector<std::string> arguments;
    std::string_view message;
};

[[nodiscard]] std::span<const BadStudy> bad_studies();
[[nodiscard]] std::span<const BadCommand> bad_commands();

/// The text of a bad study file.
[[nodiscard]] std::string text_of(const BadStudy& bad);

} // namespace bad_input
