#pragma once
/// The names beside FILE.h5, and the folder FILE.h5.parts with the walls finished since FILE.h5
/// was written: 000001.h5, 000002.h5, ..., each a study file of its own.

#include <cstdint>
#include <filesystem>
#include <vector>

namespace app {

/// `file`, or what it points to if it is a symbolic link: the other names stand beside that.
[[nodiscard]] std::filesystem::path linked_file(const std::filesystem::path& file);

[[nodiscard]] std::filesystem::path lock_of(const std::filesystem::path& file);
[[nodiscard]] std::filesystem::path parts_of(const std::filesystem::path& file);
[[nodiscard]] std::filesystem::path part_of(const std::filesystem::path& file,
                                            std::uint32_t number);

/// Numbers of the parts of a file in increasing order. Throws StoreError if the folder cannot
/// be read or is a symbolic link.
[[nodiscard]] std::vector<std::uint32_t> part_numbers(const std::filesystem::path& file);

/// Throws StoreError if the folder is there and is a symbolic link or anything else but a
/// folder.
void check_parts_folder(const std::filesystem::path& file);
/// Makes the folder unless it is there. Throws StoreError.
void make_parts_folder(const std::filesystem::path& file);
/// Removes these parts, what killed processes left there, and the folder if it is then empty.
/// Throws StoreError.
void remove_parts(const std::filesystem::path& file, const std::vector<std::uint32_t>& numbers);

} // namespace app
