#pragma once
/// The head of a study as bytes: a record of the journal, and /head in FILE.h5.

#include "app/store/store_head.hpp"

#include <string>
#include <string_view>

namespace app {

[[nodiscard]] std::string encode_head(const StoreHead& head);
/// Throws StoreError (`file`: damaged) if the bytes are no head or not a good one.
[[nodiscard]] StoreHead decode_head(std::string_view bytes, const std::string& file);

} // namespace app
