#pragma once
/// Finished walls on their way into the file of a study.

#include "app/output/progress.hpp"
#include "app/store/store.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace app {

/// Stores walls every three seconds, or a thousand at a time. A kill loses those that wait
/// here.
class RowBuffer {
  public:
    explicit RowBuffer(Store& store) : store_(store) {}
    void add(WallRow row)
    {
        rows_.push_back(std::move(row));
        if (rows_.size() >= kMost || steady_seconds() - last_ > kSeconds) flush();
    }
    void flush()
    {
        if (!rows_.empty()) store_.append(rows_);
        rows_.clear();
        last_ = steady_seconds();
    }

  private:
    static constexpr std::size_t kMost = 1000;
    static constexpr double kSeconds = 3.0;
    Store& store_;
    std::vector<WallRow> rows_;
    double last_ = steady_seconds();
};

} // namespace app
