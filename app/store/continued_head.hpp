#pragma once
/// How two heads of studies differ, and whether a stored study may go on as another.

#include "app/store/store_head.hpp"

#include <string>

namespace app {

/// Lines in which two texts differ, `- ` only in `before`, `+ ` only in `after`, in order, at
/// most `most` lines and then how many more; long lines are cut. Empty if equal.
[[nodiscard]] std::string text_difference(const std::string& before, const std::string& after,
                                          std::size_t most = 40);

/// Revision of the solver as an identity states it: "2"; empty in files of before 0.2.0.
[[nodiscard]] std::string solver_revision(const std::string& identity);
/// "revision 2 of the solver"; of an empty one "an earlier revision of the solver".
[[nodiscard]] std::string revision_words(const std::string& revision);

/// Text that is equal for two heads of one study, line by line: identity, seed, shard and
/// columns.
[[nodiscard]] std::string study_text(const StoreHead& head);

/// Lines in which two studies differ, as text_difference: those of their inputs; of two with
/// equal inputs those of study_text. A seed or a key that stands in both is then shown once.
[[nodiscard]] std::string study_difference(const StoreHead& before, const StoreHead& after);

/// The head with which a stored study goes on, if it may. `wanted` may have more samples,
/// further levels after the stored ones, another configuration text and other sessions; the
/// largest number of samples is added to `design_sizes` if it exceeds the last, and sessions
/// are added after the stored ones. Precision stays as stored. A file without spandrels, of a
/// version before, goes on without. Throws StoreError(`file`: what
/// differs, what to do) if revision, identity, seed, columns, shard or stored levels differ, or
/// if fewer samples are wanted than before.
[[nodiscard]] StoreHead continued_head(const std::string& file, const StoreHead& stored,
                                       const StoreHead& wanted);

} // namespace app
