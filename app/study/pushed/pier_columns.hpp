#pragma once
/// Piers and spandrels in the file of a study: one table of each says which facts are stored.

#include "app/store/store_head.hpp"
#include "app/store/store_row.hpp"
#include "app/study/pushed/pier_facts.hpp"
#include "app/study/pushed/pushed_wall.hpp"
#include "dem/scene/wall.hpp"

#include <vector>

namespace app {

struct LoadInput;
struct Masonry;

/// Places of the piers of a study's walls, and columns of their facts; nothing where piers are
/// not told apart.
[[nodiscard]] StorePiers stored_piers_of(const Masonry& masonry, const LoadInput& load);

/// The piers of a wall as a row; NaN throughout where nothing was read of them.
[[nodiscard]] PierRow pier_row(const PushedWall& wall, const StorePiers& piers);

/// Facts of a row that is stored; nothing where nothing was read of its piers.
[[nodiscard]] std::vector<PierFacts> pier_facts_of(const PierRow& row, const StorePiers& piers);

[[nodiscard]] std::vector<dem::Pier> piers_of(const StorePiers& piers);

/// The same of spandrels, which have no curves of their own.
[[nodiscard]] StorePiers stored_spandrels_of(const Masonry& masonry, const LoadInput& load);
[[nodiscard]] PierRow spandrel_row(const PushedWall& wall, const StorePiers& spandrels);
[[nodiscard]] std::vector<SpandrelFacts> spandrel_facts_of(const PierRow& row,
                                                           const StorePiers& spandrels);
[[nodiscard]] std::vector<dem::Spandrel> spandrels_of(const StorePiers& spandrels);

} // namespace app
