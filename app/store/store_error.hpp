#pragma once
/// What goes wrong with the file of a study: the only exception that leaves the store for a bad
/// file, a bad disk or a file in use.

#include <stdexcept>

namespace app {

/// what() names the file, the reason and what to do. Nothing that was stored before is lost.
class StoreError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

} // namespace app
