#pragma once
/// The tables of scaling.cpp.

#include "app/output/table/table.hpp"

namespace bench {

/// Threads: the same ensemble on one core and on all, run in turns.
[[nodiscard]] app::Table thread_table();

/// Blocks: cost of a block-step from 100 to 100 000 blocks in one wall.
[[nodiscard]] app::Table block_table();

/// Stones: cost of a contact where blocks share their matrices, and where each has its own.
[[nodiscard]] app::Table stone_table();

/// Samples: 10 to 100 000 tiny walls, memory against number.
[[nodiscard]] app::Table sample_table();

} // namespace bench
