#pragma once
/// Faults of the file of a study: the only exceptions that leave the store for a bad
/// file, a bad disk or a file in use.

#include <filesystem>
#include <stdexcept>
#include <string>

namespace app {

/// what() names the file, the reason and what to do. Nothing that was stored before is lost.
class StoreError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// There is no such file, it holds no study, or another than the one asked for: the program
/// ends with code 2, as for any bad input.
class BadStoredStudy : public StoreError {
  public:
    using StoreError::StoreError;
};

/// Throws BadStoredStudy: what is wrong with the file, and what to do.
[[noreturn]] void damaged(const std::filesystem::path& file, const std::string& why);

} // namespace app
