#include "app/fragility_text.hpp"

#include "app/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace app {
namespace {

struct Parts {
    std::string value, lower, upper, error;
};

/// "a [b, c]" or "a +- b"; nothing for other texts.
std::optional<Parts> parts_of(const std::string& cell)
{
    if (const auto at = cell.find(" +- "); at != std::string::npos)
        return Parts{cell.substr(0, at), "", "", cell.substr(at + 4)};
    const auto open = cell.find(" ["), comma = cell.find(", ", open);
    if (open == std::string::npos || comma == std::string::npos || cell.back() != ']')
        return {};
    const auto bound = [](const std::string& text) {
        return text == "no limit" ? std::string() : text;
    };
    return Parts{cell.substr(0, open), bound(cell.substr(open + 2, comma - open - 2)),
                 bound(cell.substr(comma + 2, cell.size() - comma - 3)), ""};
}

struct Kinds {
    bool interval = false, error = false;
};

Kinds kinds_of(const Table& t, std::size_t column)
{
    Kinds k;
    for (const auto& row : t.rows)
        if (const auto p = parts_of(row[column]))
            (p->error.empty() ? k.interval : k.error) = true;
    return k;
}

/// "median [%]" and "lower": "median lower [%]"
std::string head_with(const std::string& head, const std::string& what)
{
    const auto unit = head.rfind(" [");
    if (unit == std::string::npos) return head + " " + what;
    return head.substr(0, unit) + " " + what + head.substr(unit);
}

} // namespace

std::string with_interval(double value, double lower, double upper, int decimals)
{
    if (!std::isfinite(value)) return {};
    const auto bound = [&](double b) {
        return std::isfinite(b) ? fixed(b, decimals) : std::string("no limit");
    };
    return fixed(value, decimals) + " [" + bound(lower) + ", " + bound(upper) + "]";
}

std::string with_interval(double value, const fragility::Interval& i, int decimals)
{
    return with_interval(value, i.lower, i.upper, decimals);
}

std::string with_error(double value, double std_error, int decimals)
{
    if (!std::isfinite(value)) return {};
    if (!std::isfinite(std_error)) return fixed(value, decimals);
    return fixed(value, decimals) + " +- " + fixed(std_error, decimals);
}

int decimals_for(double size)
{
    if (!std::isfinite(size) || size == 0.0) return 3;
    const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(size))));
    return std::clamp(2 - magnitude, 0, 6);
}

std::string percent_text(double share) { return number(100.0 * share, 6) + " %"; }

Table plain_numbers(const Table& t)
{
    Table plain{t.caption, {}, std::vector<std::vector<std::string>>(t.rows.size())};
    for (std::size_t c = 0; c < t.head.size(); ++c) {
        const Kinds kinds = kinds_of(t, c);
        plain.head.push_back(t.head[c]);
        if (kinds.error) plain.head.push_back(head_with(t.head[c], "std error"));
        if (kinds.interval) {
            plain.head.push_back(head_with(t.head[c], "lower"));
            plain.head.push_back(head_with(t.head[c], "upper"));
        }
        for (std::size_t r = 0; r < t.rows.size(); ++r) {
            const Parts p = parts_of(t.rows[r][c]).value_or(Parts{t.rows[r][c], "", "", ""});
            auto& row = plain.rows[r];
            row.push_back(p.value);
            if (kinds.error) row.push_back(p.error);
            if (kinds.interval) row.insert(row.end(), {p.lower, p.upper});
        }
    }
    return plain;
}

std::string file_name(const std::string& text)
{
    std::string name;
    for (const char c : text) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                           (c >= '0' && c <= '9') || c == '-' || c == '.' || c == '_';
        name += plain ? c : '_';
    }
    return name.empty() || name.front() == '.' ? "_" + name : name;
}

} // namespace app
