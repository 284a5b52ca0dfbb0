#include "app/input/study/distribution_text.hpp"

#include "app/input/study/units.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"
#include "uq/marginals/marginal_forms.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

namespace app {
namespace {

struct Parameter {
    std::string_view name;
    std::string_view value;
};

struct Call {
    std::string_view text; ///< whole, for messages
    std::string_view name;
    std::vector<Parameter> parameters;
};

using uq::MarginalForm;

std::string form_text(const MarginalForm& f)
{
    std::string text(f.name);
    for (std::size_t i = 0; i < f.parameters.size(); ++i)
        text += (i == 0 ? "(" : ", ") + std::string(f.parameters[i].name) + " ...";
    return text + ")";
}

std::vector<std::string_view> form_names()
{
    std::vector<std::string_view> names;
    for (const MarginalForm& f : uq::marginal_forms())
        if (names.empty() || names.back() != f.name) names.push_back(f.name);
    names.push_back("empirical");
    return names;
}

std::string forms_of(std::string_view name)
{
    std::string text;
    for (const MarginalForm& f : uq::marginal_forms())
        if (f.name == name) text += (text.empty() ? "" : " or ") + form_text(f);
    return text;
}

Parameter split_parameter(std::string_view text, std::string_view item)
{
    const std::size_t blank = item.find_first_of(" \t");
    if (blank == std::string_view::npos)
        throw BadValue(in_quotes(item) + " in " + in_quotes(text) +
                       " has no value; write a name and a value, such as \"cov 0.30\"");
    return {item.substr(0, blank), trimmed(item.substr(blank))};
}

Call split_call(std::string_view text)
{
    const std::size_t open = text.find('(');
    if (!text.ends_with(')') || text.find('(', open + 1) != std::string_view::npos)
        throw BadValue(in_quotes(text) +
                       " is not a distribution; write one pair of brackets, such as "
                       "\"normal(mean 31.8 deg, cov 0.20)\"");
    return {text, trimmed(text.substr(0, open)), {}};
}

std::string_view inside(std::string_view text)
{
    const std::size_t open = text.find('(');
    return trimmed(text.substr(open + 1, text.size() - open - 2));
}

/// A coefficient of variation: "0.20" or "20 %".
double coefficient_of_variation(std::string_view text)
{
    constexpr double kMost = 2.0; // beyond it a percentage was meant
    const bool percent = text.ends_with('%');
    const std::string_view digits = percent ? trimmed(text.substr(0, text.size() - 1)) : text;
    const double value = parse_quantity(digits, "") / (percent ? 100.0 : 1.0);
    if (value < kMost) return value;
    const std::string given(digits);
    throw BadValue("cov " + given +
                   (percent ? " % is out of range; write less than 200 %"
                            : " is a scatter of " + given + " times the mean; write \"cov " +
                                  given + " %\" if that was meant, and less than 2 otherwise"));
}

/// Takes a parameter out of the call.
std::optional<double> take(Call& call, std::string_view name, std::string_view unit)
{
    const auto is_it = [&](const Parameter& p) { return p.name == name; };
    const auto found = std::ranges::find_if(call.parameters, is_it);
    if (found == call.parameters.end()) return {};
    const double value = name == "cov" ? coefficient_of_variation(found->value)
                                       : parse_quantity(found->value, unit);
    call.parameters.erase(found);
    if (std::ranges::find_if(call.parameters, is_it) != call.parameters.end())
        throw BadValue(in_quotes(name) + " is given twice in " + in_quotes(call.text) +
                       "; keep one of them");
    return value;
}

bool fits(const MarginalForm& f, const Call& call)
{
    if (f.name != call.name || f.parameters.size() != call.parameters.size()) return false;
    return std::ranges::all_of(call.parameters, [&](const Parameter& p) {
        return std::ranges::find(f.parameters, p.name, &uq::ShapeParameter::name) !=
               f.parameters.end();
    });
}

void refuse_decimal_comma(std::string_view text)
{
    const auto is_digit = [](unsigned char c) { return std::isdigit(c) != 0; };
    for (std::size_t i = 1; i + 1 < text.size(); ++i) {
        if (text[i] != ',' || !is_digit(text[i - 1]) || !is_digit(text[i + 1])) continue;
        std::string point(text);
        point[i] = '.';
        throw BadValue("comma inside a number of " + in_quotes(text) +
                       "; write a decimal point, " + in_quotes(point));
    }
}

uq::Shape shape_of(Call& call, std::string_view unit)
{
    for (const MarginalForm& f : uq::marginal_forms()) {
        if (!fits(f, call)) continue;
        std::vector<double> values;
        for (const uq::ShapeParameter& p : f.parameters) {
            const auto value = take(call, p.name, p.bare ? "" : unit);
            if (!value) break; // one name twice
            values.push_back(*value);
        }
        if (values.size() == f.parameters.size()) return f.make(values);
    }
    refuse_decimal_comma(call.text);
    throw BadValue(in_quotes(call.text) + " does not have the parameters of " +
                   std::string(call.name) + "; write " + forms_of(call.name) +
                   ", and from ..., to ... to cut it off");
}

uq::Marginal empirical(std::string_view text, std::string_view unit)
{
    uq::Empirical data{parse_quantities(inside(text), unit)};
    std::ranges::sort(data.sorted);
    return {data};
}

/// The call that a text makes, its parameters as they stand there.
Call call_of(std::string_view text)
{
    Call call = split_call(text);
    for (const std::string_view item : split(inside(text), ","))
        call.parameters.push_back(split_parameter(text, item));
    return call;
}

/// All parameters that a distribution can have, in the order in which they are written.
std::vector<uq::ShapeParameter> parameters_of(std::string_view distribution)
{
    std::vector<uq::ShapeParameter> all;
    const auto add = [&](const uq::ShapeParameter& p) {
        if (std::ranges::find(all, p.name, &uq::ShapeParameter::name) == all.end())
            all.push_back(p);
    };
    for (const MarginalForm& f : uq::marginal_forms())
        if (f.name == distribution) std::ranges::for_each(f.parameters, add);
    for (const char* const end : {"from", "to"}) add({end});
    return all;
}

uq::Marginal marginal_of(std::string_view text, std::string_view unit)
{
    Call call = split_call(text);
    const auto names = form_names();
    if (std::ranges::find(names, call.name) == names.end())
        throw BadValue("unknown distribution " + in_quotes(call.name) + "; " +
                       suggestion(call.name, names));
    if (call.name == "empirical") return empirical(text, unit);
    call = call_of(text);
    uq::Marginal m;
    m.lower = take(call, "from", unit).value_or(m.lower);
    m.upper = take(call, "to", unit).value_or(m.upper);
    m.shape = shape_of(call, unit);
    return m;
}

/// Refuses a cut that leaves next to nothing: a slip of a unit or of a digit.
void refuse_remnant(const uq::Marginal& m, std::string_view text)
{
    constexpr double kLeastShare = 1e-6; // choice: no result depends on it
    const double share = uq::share_left(m);
    if (share < kLeastShare)
        throw BadValue(in_quotes(text) + " leaves " + number(share, 2) +
                       " of the distribution, next to nothing; write from and to that leave " +
                       number(kLeastShare, 2) + " of it or more");
}

} // namespace

bool is_distribution(std::string_view text)
{
    return !text.empty() && std::isalpha(static_cast<unsigned char>(text.front())) != 0 &&
           text.find('(') != std::string_view::npos;
}

uq::Marginal parse_distribution(std::string_view text, std::string_view unit)
{
    try {
        const uq::Marginal m = marginal_of(text, unit);
        uq::check(m);
        refuse_remnant(m, text);
        return m;
    } catch (const BadValue&) {
        throw;
    } catch (const std::invalid_argument& bad) {
        const std::string si(si_unit(unit));
        throw BadValue(in_quotes(text) + ": " + bad.what() +
                       (si == unit || si.empty() ? "" : " (numbers in " + si + ")"));
    }
}

std::vector<double> empirical_values(std::string_view text, std::string_view unit)
{
    if (split_call(text).name != "empirical") return {};
    return parse_quantities(inside(text), unit);
}

std::string canonical_distribution(std::string_view text, std::string_view unit)
{
    const std::string name(split_call(text).name);
    if (name == "empirical")
        return name + "(" +
               format_quantities(std::get<uq::Empirical>(empirical(text, unit).shape).sorted,
                                 unit) +
               ")";
    Call call = call_of(text);
    std::string inside;
    for (const uq::ShapeParameter& p : parameters_of(name)) {
        const std::string_view of = p.bare ? "" : unit;
        const std::optional<double> value = take(call, p.name, of);
        if (value)
            inside += (inside.empty() ? "" : ", ") + std::string(p.name) + " " +
                      format_quantities({&*value, 1}, of);
    }
    return name + "(" + inside + ")";
}

std::string distribution_help()
{
    std::string text = "In place of the number of a material, a distribution:\n";
    for (const MarginalForm& f : uq::marginal_forms()) text += "  " + form_text(f) + "\n";
    return text + "  empirical(values)\n"
                  "each but the last with \", from ..., to ...\" to cut it off. Quantities "
                  "carry their unit; cov, sigma_log and shape have none; cov may be in "
                  "percent: cov 20 %.\n";
}

} // namespace app
