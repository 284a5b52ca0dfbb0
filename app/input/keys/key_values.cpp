#include "app/input/keys/key_values.hpp"

#include "app/input/study/distribution_text.hpp"
#include "app/input/study/units.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <variant>

namespace app {
namespace {

std::vector<std::string_view> words_of(const Key& key)
{
    std::vector<std::string_view> words;
    for (const Named& n : key.names) words.push_back(n.word);
    return words;
}

std::string range_text(const Key& key)
{
    return key.range.left + number(key.range.low, 17) + ", " + number(key.range.high, 17) +
           key.range.right + (key.unit.empty() ? "" : " ") + std::string(key.unit);
}

bool starts_with_letter(std::string_view text)
{
    const char c = text.empty() ? '\0' : text.front();
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

std::vector<double> parse_numbers(const Key& key, std::string_view text)
{
    switch (key.kind) {
    case Kind::list:
        return parse_quantities(text, key.unit);
    case Kind::count:
        return {parse_count(text)};
    default:
        return {parse_quantity(text, key.unit)};
    }
}

/// The range of the key holds for every draw.
void cut_off(const Key& key, std::string_view text, RandomInput& random)
{
    constexpr double kMostCut = 0.5;
    uq::Marginal& m = random.marginal;
    const double low = to_si(key.range.low, key.unit), high = to_si(key.range.high, key.unit);
    random.cut = (low > m.lower ? uq::cdf(m, low) : 0.0) +
                 (high < m.upper ? uq::complement(m, high) : 0.0);
    const bool measured = std::holds_alternative<uq::Empirical>(m.shape);
    if (!(random.cut < (measured ? 1e-12 : kMostCut)))
        throw BadValue(in_quotes(text) + " lies outside the range of this key, " +
                       range_text(key) + "; check its unit");
    m.lower = std::max(m.lower, low);
    m.upper = std::min(m.upper, high);
}

} // namespace

bool in_range(double si, const Key& key)
{
    const double low = to_si(key.range.low, key.unit), high = to_si(key.range.high, key.unit);
    return (key.range.left == '[' ? si >= low : si > low) &&
           (key.range.right == ']' ? si <= high : si < high);
}

std::optional<RandomInput> parse_random(const Key& key, std::string_view text)
{
    if (key.kind == Kind::text || !is_distribution(text)) return {};
    if (key.varies == Varies::never)
        throw BadValue(in_quotes(text) + " is a distribution, but " + std::string(key.name) +
                       " is the same for all walls" +
                       std::string(key.fixed_because.empty() ? "" : ", ") +
                       std::string(key.fixed_because) + "; write a number");
    RandomInput random;
    random.key = key.name;
    random.marginal = parse_distribution(text, key.unit);
    random.mean = uq::mean(random.marginal);
    random.varies = key.varies;
    random.unit = key.unit;
    random.place = key.field.place;
    cut_off(key, text, random);
    return random;
}

std::string allowed_values(const Key& key)
{
    if (key.kind == Kind::text) return "text";
    if (key.kind == Kind::word) return listed(words_of(key));
    std::string text;
    for (const Named& n : key.names) text += std::string(n.word) + ", ";
    return text + (key.kind == Kind::count ? "whole in " : "") + range_text(key);
}

std::vector<double> parse_value(const Key& key, std::string_view text)
{
    if (key.kind == Kind::text) {
        if (text == "none" && key.derived.rule == text) return {}; // the default, written out
        return {text.begin(), text.end()};
    }
    for (const Named& n : key.names) {
        if (text == n.word) return {n.value};
    }
    if (key.kind == Kind::word || (!key.names.empty() && starts_with_letter(text))) {
        const std::string_view nearest = nearest_word(text, words_of(key));
        throw BadValue(in_quotes(text) + " is not one of " + allowed_values(key) +
                       (nearest.empty() ? "" : "; did you mean " + in_quotes(nearest) + "?"));
    }
    const std::vector<double> values = parse_numbers(key, text);
    for (const double value : values) {
        if (in_range(value, key)) continue;
        throw BadValue(in_quotes(text) + " is out of range; must be in " + range_text(key));
    }
    return values;
}

std::string value_text(const Key& key, const Study& study)
{
    const std::vector<double> values = key.field.get(study);
    if (values.empty()) return {};
    if (key.kind == Kind::text) return {values.begin(), values.end()};
    for (const Named& n : key.names) {
        if (values.front() == n.value) return std::string(n.word);
    }
    return format_quantities(values, key.unit);
}

std::string default_text(const Key& key)
{
    if (!key.example.empty()) return "required";
    if (!key.derived.rule.empty()) return std::string(key.derived.rule);
    return value_text(key, Study{});
}

} // namespace app
