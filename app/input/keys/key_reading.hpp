#pragma once
/// Reading a study file by a table of keys.

#include "app/input/keys/study_keys.hpp"

#include <span>
#include <string_view>

namespace app {

struct StudyFile;

/// @param free_section has names of its own: they are not in the table
/// @throws ConfigError at the first section or key that is not in the table
void refuse_unknown(const StudyFile& file, std::span<const Key> keys,
                    std::string_view free_section = "");

/// Puts the value that study.source gives into its field. A field whose value is a distribution
/// holds the mean, and the distribution is added to study.random.
/// @throws ConfigError if the value is not one of the key, or if it must be given and is not
void read_key(const Key& key, Study& study);

} // namespace app
