#include "app/drawing/json_keys.hpp"

#include "app/drawing/outlines/drawing_file.hpp"
#include "app/text/words.hpp"

#include <algorithm>

namespace app {
namespace {

std::string short_name(std::string_view key) { return readable_name(key.substr(0, 40)); }

} // namespace

void UnknownKeys::count(const nlohmann::json& object,
                        std::initializer_list<std::string_view> known)
{
    for (const auto& [key, value] : object.items())
        if (std::ranges::find(known, key) == known.end()) ++found_[short_name(key)];
}

void UnknownKeys::note(RawDrawing& drawing) const
{
    std::string list;
    for (const auto& [key, n] : found_)
        list += (list.empty() ? "" : ", ") + std::to_string(n) + " " + key;
    if (!list.empty())
        drawing.notes.push_back("Keys that are not read were ignored: " + list + ".");
}

void DifferentKeys::add(const std::string& key, const DrawingFrame& frame, int line, int begin)
{
    if (keys_.insert(key).second) return;
    refuse(frame, line,
           in_quotes(short_name(key)) + " stands twice in the object that begins on line " +
               std::to_string(begin) + "; keep one of them, or join what they hold");
}

std::string keys_of(const nlohmann::json& object)
{
    constexpr int kMost = 8;
    std::string keys;
    int n = 0;
    for (const auto& [key, value] : object.items())
        if (++n <= kMost) keys += (keys.empty() ? "" : ", ") + short_name(key);
    return keys.empty() ? "nothing" : n > kMost ? keys + ", ..." : keys;
}

} // namespace app
