#include "app/study/fragility_text.hpp"

#include "app/input/number_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace app {
namespace {

struct Parts {
    std::string value, lower, upper, error;
    bool marked = false; ///< the value
};

/// Takes the mark off.
bool unmark(std::string& number)
{
    if (!number.ends_with(kExtrapolated)) return false;
    number.resize(number.size() - kExtrapolated.size());
    return true;
}

bool is_number(const std::string& text)
{
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
}

/// "a", "a [b, c]" or "a +- b", taken apart; other texts are a value.
Parts parts_of(const std::string& cell)
{
    Parts p{cell, "", "", ""};
    const auto open = cell.find(" ["), comma = cell.find(", ", open);
    if (const auto at = cell.find(" +- "); at != std::string::npos) {
        p = {cell.substr(0, at), "", "", cell.substr(at + 4)};
    } else if (open != std::string::npos && comma != std::string::npos && cell.back() == ']') {
        p = {cell.substr(0, open), cell.substr(open + 2, comma - open - 2),
             cell.substr(comma + 2, cell.size() - comma - 3), ""};
    }
    for (std::string* const bound : {&p.lower, &p.upper}) {
        unmark(*bound);
        if (*bound == "no limit") bound->clear();
    }
    p.marked = unmark(p.value);
    return p;
}

bool has_interval(const std::string& cell)
{
    return cell.ends_with("]") && cell.find(" [") != std::string::npos &&
           cell.find(", ", cell.find(" [")) != std::string::npos;
}

struct Kinds {
    bool interval = false, error = false, mark = false;
};

Kinds kinds_of(const Table& t, std::size_t column)
{
    Kinds k;
    for (const auto& row : t.rows) {
        const Parts p = parts_of(row[column]);
        k.error = k.error || !p.error.empty();
        k.interval = k.interval || has_interval(row[column]);
        k.mark = k.mark || p.marked;
    }
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

double known_to(std::span<const fragility::Observation> limits)
{
    double end = 0.0;
    for (const fragility::Observation& o : limits) end = std::max(end, o.lower);
    return end;
}

double common_end(std::span<const fragility::Observation> limits)
{
    const double largest = known_to(limits);
    double end = largest;
    for (const fragility::Observation& o : limits)
        if (o.lower < o.upper && o.lower >= largest * (1.0 - kEndsTogether))
            end = std::min(end, o.lower);
    return end;
}

std::string extrapolated_text(const std::string& whose)
{
    return std::string(kExtrapolated) + ": extrapolated, beyond the largest drift at which " +
           whose + " reached the limit state or still stood where its curve ended";
}

std::string with_mark(double value, int decimals, double known_to)
{
    const bool beyond = value > known_to * (1.0 + kEndsTogether);
    return fixed(value, decimals) + std::string(beyond ? kExtrapolated : "");
}

std::string with_interval(double value, double lower, double upper, int decimals,
                          double known_to)
{
    if (!std::isfinite(value)) return {};
    const auto bound = [&](double b) {
        return std::isfinite(b) ? with_mark(b, decimals, known_to) : std::string("no limit");
    };
    return with_mark(value, decimals, known_to) + " [" + bound(lower) + ", " + bound(upper) +
           "]";
}

std::string with_interval(double value, const fragility::Interval& i, int decimals,
                          double known_to)
{
    return with_interval(value, i.lower, i.upper, decimals, known_to);
}

std::string rounded_down(double value, int decimals)
{
    const std::string nearest = fixed(value, decimals);
    if (std::stod(nearest) <= value) return nearest;
    return fixed(std::stod(nearest) - std::pow(10.0, -decimals), decimals);
}

std::string median_bound(const fragility::MedianBound& bound, int decimals)
{
    if (!bound.median_bounded) return {};
    return (bound.strictly ? "> " : ">= ") + rounded_down(bound.median_above, decimals);
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
        if (kinds.mark)
            plain.head.push_back(t.head[c].substr(0, t.head[c].rfind(" [")) + " extrapolated");
        if (kinds.error) plain.head.push_back(head_with(t.head[c], "std error"));
        if (kinds.interval) {
            plain.head.push_back(head_with(t.head[c], "lower"));
            plain.head.push_back(head_with(t.head[c], "upper"));
        }
        for (std::size_t r = 0; r < t.rows.size(); ++r) {
            const Parts p = parts_of(t.rows[r][c]);
            auto& row = plain.rows[r];
            row.push_back(p.value);
            if (kinds.mark) row.emplace_back(!is_number(p.value) ? "" : p.marked ? "1" : "0");
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
