#include "uq/reliability/external_program_result.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>

namespace uq {

namespace {

using nlohmann::json;

std::optional<std::string> whole(const std::filesystem::path& file)
{
    std::ifstream in(file, std::ios::binary);
    if (!in) return std::nullopt;
    return std::string(std::istreambuf_iterator<char>(in), {});
}

bool starts_with_not_a_number(const std::string& text, std::size_t byte)
{
    // The complaint is about the last character read: the word may begin up to 3 before it.
    for (const std::string word : {"NaN", "nan", "Infinity", "inf"})
        for (std::size_t back = 0; back <= 3 && back <= byte; ++back)
            if (text.compare(byte - back, word.size(), word) == 0) return true;
    return false;
}

std::string not_json(const std::string& text, std::size_t byte)
{
    const std::string place = "byte " + std::to_string(byte);
    if (byte > text.size()) return "result ends too early (half-written?) at " + place;
    if (starts_with_not_a_number(text, byte - 1))
        return "result holds NaN or infinity, not a number, at " + place;
    return "result is not JSON, from " + place;
}

ProgramResult failed(std::string why) { return {{}, std::move(why), false}; }

/// Why `value` is no answer; empty if it is a finite number.
std::string not_a_number(const json& value)
{
    if (value.is_null()) return "null, not a number";
    if (value.is_string())
        return "text (\"" + value.get<std::string>().substr(0, 40) + "\"), not a number";
    if (!value.is_number())
        return std::string("of type ") + value.type_name() + ", not a number";
    return std::isfinite(value.get<double>()) ? "" : "not finite";
}

ProgramResult numbers(const json& result, const std::vector<std::string>& responses)
{
    if (!result.is_object()) return failed("result is not a JSON object");
    if (const auto own = result.find("failure"); own != result.end() && !own->is_null())
        return {{},
                "the program says: " +
                    (own->is_string() ? own->get<std::string>() : own->dump()),
                true};
    const auto all = result.find("responses");
    if (all == result.end() || !all->is_object())
        return failed("result has no object \"responses\"");
    ProgramResult r{Eigen::VectorXd(static_cast<Eigen::Index>(responses.size())), {}, false};
    for (std::size_t i = 0; i < responses.size(); ++i) {
        const auto value = all->find(responses[i]);
        if (value == all->end())
            return failed("response \"" + responses[i] + "\" is missing in the result");
        const std::string why = not_a_number(*value);
        if (!why.empty()) return failed("response \"" + responses[i] + "\" is " + why);
        r.y(static_cast<Eigen::Index>(i)) = value->get<double>();
    }
    return r;
}

} // namespace

std::string input_text(std::uint64_t sample, const std::vector<std::string>& parameters,
                       const Eigen::VectorXd& x)
{
    nlohmann::ordered_json input;
    input["sample"] = sample;
    input["parameters"] = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < parameters.size(); ++i)
        input["parameters"][parameters[i]] = x(static_cast<Eigen::Index>(i));
    return input.dump(1) + "\n";
}

ProgramResult read_result(const std::filesystem::path& file,
                          const std::vector<std::string>& responses)
{
    const std::optional<std::string> text = whole(file);
    if (!text) return failed("there is no result file");
    if (text->find_first_not_of(" \t\r\n") == std::string::npos)
        return failed("the result is empty");
    try {
        return numbers(json::parse(*text), responses);
    } catch (const json::parse_error& e) {
        return failed(not_json(*text, e.byte));
    } catch (const json::out_of_range&) {
        return failed("result holds a number too large for a double");
    } catch (const json::exception& e) {
        return failed(std::string("result cannot be read: ") + e.what());
    }
}

std::string last_lines(const std::filesystem::path& file, int lines)
{
    constexpr std::size_t longest = 2000;
    std::string text = whole(file).value_or("");
    if (text.size() > longest) text.erase(0, text.size() - longest);
    std::vector<std::string> all;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        if (!line.empty()) all.push_back(line);
    std::string joined;
    const auto wanted = static_cast<std::size_t>(std::max(0, lines));
    for (std::size_t i = all.size() - std::min(all.size(), wanted); i < all.size(); ++i)
        joined += (joined.empty() ? "" : " | ") + all[i];
    return joined;
}

} // namespace uq
