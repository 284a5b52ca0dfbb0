#include "ground/record_head.hpp"

#include <algorithm>
#include <cmath>

namespace ground {
namespace {

/// The unit of a word: m/s2, or acc_m_s2. Empty if it has none.
std::string unit_of(std::string word)
{
    if (acceleration_unit(word) > 0.0) return word;
    const std::size_t end = word.find('_');
    if (end == std::string::npos) return {};
    word.erase(0, end + 1);
    std::ranges::replace(word, '_', '/');
    return unit_of(std::move(word));
}

} // namespace

std::vector<std::string> words_of(std::string_view text)
{
    text = stripped(text.substr(0, 400));
    if (text.starts_with('%')) text.remove_prefix(1); // elsewhere it is part of a unit: %g
    std::string line(text);
    std::ranges::replace_if(
        line,
        [](char c) {
            return std::string_view("[](),;:=#\t\"").find(c) != std::string_view::npos;
        },
        ' ');
    std::vector<std::string> words;
    std::string_view rest = line;
    while (!(rest = stripped(rest)).empty()) {
        words.emplace_back(rest.substr(0, rest.find(' ')));
        rest.remove_prefix(words.back().size());
    }
    return words;
}

bool names_columns(std::string_view line)
{
    const std::vector<std::string> words = words_of(lower(line));
    return !words.empty() && (words.front().starts_with("time") || words.front() == "t" ||
                              words.front().starts_with("t_"));
}

std::string unit_above(const RecordText& text, std::size_t lines)
{
    std::string named, any;
    for (std::size_t i = 0; i < lines; ++i) {
        const bool names = names_columns(text.lines[i]);
        for (const std::string& word : words_of(text.lines[i]))
            if (std::string unit = names ? unit_of(word) : word;
                acceleration_unit(unit) > 0.0 && (names || unit != "G"))
                (names ? named : any) = std::move(unit);
    }
    return named.empty() ? any : named;
}

void check_unsaid(const RecordText& text, std::size_t line, const std::vector<double>& values)
{
    constexpr double kMost = 4.0; // [g] hardly any record has more
    for (const double a : values)
        if (std::abs(a) > kMost)
            refuse(text, line,
                   "no unit is written, and the values are too large for g; write it above the "
                   "columns, such as \"time [s], acceleration [cm/s2]\", or give "
                   "--acceleration-unit");
}

} // namespace ground
