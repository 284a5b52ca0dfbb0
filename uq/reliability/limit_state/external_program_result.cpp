#include "uq/reliability/limit_state/external_program_result.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace uq {

namespace {

using json = nlohmann::ordered_json;

constexpr std::size_t kLargestResult = std::size_t{16} << 20; ///< [bytes]
constexpr std::size_t kErrorsRead = 2000;                     ///< [bytes], from the end
constexpr int kDeepest = 100; ///< levels of brackets in a result

struct Text {
    std::string text;
    std::string failure; ///< why there is none
};

/// At most the last `most` bytes of a regular file. A program may leave anything in its place:
/// a pipe would be waited for without end, a device never ends.
Text end_of(const std::filesystem::path& file, std::size_t most)
{
    const int fd = open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (fd < 0) return {{}, "there is no result file"};
    struct stat about {};
    if (fstat(fd, &about) != 0 || !S_ISREG(about.st_mode)) {
        close(fd);
        return {{}, "the result is not a regular file"};
    }
    const auto size = static_cast<std::size_t>(about.st_size);
    std::string text(std::min(size, most), '\0');
    std::size_t got = 0;
    for (ssize_t n = 1; n > 0 && got<text.size(); got += n> 0 ? std::size_t(n) : 0)
        n = pread(fd, text.data() + got, text.size() - got,
                  static_cast<off_t>(size - text.size() + got));
    close(fd);
    text.resize(got);
    return {text, size > most
                      ? "the result is larger than " + std::to_string(most >> 20) + " MiB"
                      : ""};
}

struct TooDeep {};
struct Twice {
    std::string name;
};

/// @throws TooDeep, Twice, json::exception
json parsed(const std::string& text)
{
    using Event = json::parse_event_t;
    std::vector<std::set<std::string>> names; // of the objects that are open
    return json::parse(text, [&](int depth, Event event, json& value) {
        if (depth > kDeepest) throw TooDeep();
        if (event == Event::object_start) names.emplace_back();
        if (event == Event::object_end) names.pop_back();
        if (event == Event::key && !names.back().insert(value.get<std::string>()).second)
            throw Twice{value.get<std::string>()};
        return true;
    });
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
    json input;
    input["sample"] = sample;
    input["parameters"] = json::object();
    for (std::size_t i = 0; i < parameters.size(); ++i)
        input["parameters"][parameters[i]] = x(static_cast<Eigen::Index>(i));
    return input.dump(1) + "\n";
}

ProgramResult read_result(const std::filesystem::path& file,
                          const std::vector<std::string>& responses)
{
    const auto [text, failure] = end_of(file, kLargestResult);
    if (!failure.empty()) return failed(failure);
    if (text.find_first_not_of(" \t\r\n") == std::string::npos)
        return failed("the result is empty");
    try {
        return numbers(parsed(text), responses);
    } catch (const TooDeep&) {
        return failed("the brackets of the result are more than " + std::to_string(kDeepest) +
                      " deep");
    } catch (const Twice& twice) {
        return failed("result names \"" + twice.name.substr(0, 40) + "\" twice");
    } catch (const json::parse_error& e) {
        return failed(not_json(text, e.byte));
    } catch (const json::out_of_range&) {
        return failed("result holds a number too large for a double");
    } catch (const json::exception& e) {
        return failed(std::string("result cannot be read: ") + e.what());
    }
}

std::string last_lines(const std::filesystem::path& file, int lines)
{
    std::string text = end_of(file, kErrorsRead).text;
    for (char& c : text) // what could spoil a table or a terminal
        if ((c >= 0 && c < ' ' && c != '\n') || c == 0x7f) c = ' ';
    // bytes that are no UTF-8 become its sign for them
    text = parsed(json(text).dump(-1, ' ', false, json::error_handler_t::replace));
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
