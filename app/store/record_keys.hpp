#pragma once
/// Keys about records whose values a file holds as whole paths. These differ from machine to
/// machine, and no identity compares them: it has names and sums of the records in lines of
/// their own.

#include <array>
#include <string>
#include <string_view>

namespace app {

inline constexpr std::array<std::string_view, 2> kRecordKeys = {"shaking.records",
                                                                "shaking.vertical"};

/// A configuration without the lines of these keys.
[[nodiscard]] std::string without_record_keys(const std::string& configuration);

} // namespace app
