#include "app/text/words.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace app {

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view kBlank = " \t\r";
    const std::size_t first = text.find_first_not_of(kBlank);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::string lower_case(std::string_view text)
{
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return lower;
}

std::vector<std::string_view> split(std::string_view text, std::string_view by)
{
    std::vector<std::string_view> parts;
    while (true) {
        const std::size_t at = text.find(by);
        parts.push_back(trimmed(text.substr(0, at)));
        if (at == std::string_view::npos) return parts;
        text.remove_prefix(at + by.size());
    }
}

std::vector<std::string> split_outside_brackets(std::string_view text)
{
    std::vector<std::string> parts(1);
    int depth = 0;
    for (const char c : text) {
        depth += c == '(' ? 1 : c == ')' ? -1 : 0;
        if (c == ',' && depth == 0)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    for (std::string& p : parts) p = std::string(trimmed(p));
    return parts;
}

std::string in_quotes(std::string_view text)
{
    constexpr std::size_t kLongest = 60; // [bytes]
    std::string shown(text.substr(0, kLongest));
    if (text.size() > kLongest) {
        while (!shown.empty() && (shown.back() & 0x80) != 0)
            shown.pop_back(); // whole characters
        shown += "...";
    }
    for (char& c : shown) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
    }
    return '"' + shown + '"';
}

std::string in_shell(const std::string& text)
{
    const bool plain = !text.empty() && std::ranges::all_of(text, [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '/' || c == '.' || c == '_' || c == '-' || c == '+';
    });
    if (plain) return text;
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

std::string listed(std::span<const std::string_view> words)
{
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) text += i + 1 == words.size() ? " or " : ", ";
        text += words[i];
    }
    return text;
}

std::string counted(std::size_t n, std::string_view one, std::string_view more)
{
    return std::to_string(n) + ' ' + std::string(n == 1 ? one : more);
}

int edit_distance(std::string_view a, std::string_view b)
{
    std::vector<int> row(b.size() + 1); // distance of a[0, i) to each b[0, j)
    std::iota(row.begin(), row.end(), 0);
    std::vector<int> before, two_before; // the rows of i - 1 and i - 2
    for (std::size_t i = 1; i <= a.size(); ++i) {
        two_before = std::exchange(before, row);
        row[0] = static_cast<int>(i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const int replaced = before[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({before[j] + 1, row[j - 1] + 1, replaced});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) row[j] = std::min(row[j], two_before[j - 2] + 1);
        }
    }
    return row.back();
}

std::string_view nearest_word(std::string_view wrong, std::span<const std::string_view> words)
{
    constexpr std::size_t kLongest = 100; // longer ones are no misprint of a word
    if (wrong.size() > kLongest) return {};
    std::string_view nearest;
    int fewest = 0;
    for (const std::string_view word : words) {
        const int edits = edit_distance(wrong, word);
        const bool near = 3 * edits <= static_cast<int>(word.size());
        if (near && (nearest.empty() || edits < fewest)) {
            nearest = word;
            fewest = edits;
        }
    }
    return nearest;
}

std::string suggestion(std::string_view wrong, std::span<const std::string_view> words)
{
    const std::string_view nearest = nearest_word(wrong, words);
    if (nearest.empty()) return "use " + listed(words);
    return "did you mean " + in_quotes(nearest) + "?";
}

} // namespace app
