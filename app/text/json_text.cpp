#include "app/text/json_text.hpp"

#include "app/text/number_text.hpp"

#include <cmath>

namespace app {

Json or_null(std::optional<double> x, double scale)
{
    if (!x || !std::isfinite(*x * scale)) return nullptr;
    return rounded(*x * scale, kAfterUnits);
}

Json json_of(const std::string& text) { return Json::parse(text); }

std::optional<double> number_in(const Json& object, const std::string& key)
{
    const auto found = object.find(key);
    if (found == object.end() || !found->is_number()) return {};
    return found->get<double>();
}

std::string text_of(const Json& json, int indent)
{
    return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

} // namespace app
