#pragma once
/// Counts unknown JSON keys, to report them.

#include "app/drawing/outlines/raw_drawing.hpp"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <initializer_list>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace app {

/// Counts unknown keys of objects that follow docs/drawings.md; files of COMPAS have many other
/// keys.
class UnknownKeys {
  public:
    void count(const nlohmann::json& object, std::initializer_list<std::string_view> known);

    /// "Keys that are not read were ignored: 2 holes, 1 unit."
    void note(RawDrawing& drawing) const;

  private:
    std::map<std::string, std::size_t> found_;
};

/// The keys of one object. The parser keeps the last of two values with the same key, and a
/// list of blocks would be lost.
class DifferentKeys {
  public:
    /// @param line on which the key stands
    /// @param begin line on which the object begins
    /// @throws ConfigError if the object has it already
    void add(const std::string& key, const DrawingFrame& frame, int line, int begin);

  private:
    std::set<std::string> keys_;
};

/// "outlin, layer": the keys of an object, for messages.
[[nodiscard]] std::string keys_of(const nlohmann::json& object);

} // namespace app
