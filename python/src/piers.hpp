#pragma once
/// Piers and spandrels of walls with openings, as columns of numbers.

#include "app/store/store_head.hpp"
#include "app/store/store_row.hpp"
#include "python/src/loaded_study.hpp"

#include <pybind11/pybind11.h>

#include <vector>

namespace bindings {

/// One value for each pier; empty where the wall has none.
[[nodiscard]] pybind11::dict piers_of_wall(const WallOfStudy& w);
[[nodiscard]] pybind11::dict spandrels_of_wall(const WallOfStudy& w);

/// The piers or spandrels of a file of results, gathered row by row.
class StoredPiers {
  public:
    explicit StoredPiers(const app::StorePiers& piers)
        : piers_(&piers), facts_(piers.facts.size())
    {
    }
    void add(const app::PierRow& row);
    /// Their places, and each fact by wall and pier.
    [[nodiscard]] pybind11::dict taken();

  private:
    const app::StorePiers* piers_;
    std::vector<std::vector<double>> facts_; ///< of each column, wall by wall
};

} // namespace bindings
