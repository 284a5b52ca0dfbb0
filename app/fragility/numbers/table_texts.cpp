#include "app/fragility/numbers/table_texts.hpp"

#include "app/study/answers/fragility_text.hpp"
#include "app/study/answers/mode_rule.hpp"
#include "app/text/number_text.hpp"

#include <stdexcept>

namespace app {

namespace {

std::string filled(std::string_view text, const Words& words)
{
    std::string result;
    while (!text.empty()) {
        const auto open = text.find('{'), close = text.find('}', open);
        result += text.substr(0, open);
        if (close == std::string_view::npos) break;
        const auto word = words.find(text.substr(open + 1, close - open - 1));
        if (word == words.end())
            throw std::logic_error("table texts: no word " +
                                   std::string(text.substr(open, close - open + 1)));
        result += word->second;
        text.remove_prefix(close + 1);
    }
    return result;
}

/// The text in one line: the line breaks of the file do not belong to it.
std::string one_line(std::string_view text)
{
    std::string line(text.substr(0, text.find_last_not_of('\n') + 1));
    for (char& c : line) c = c == '\n' ? ' ' : c;
    return line;
}

/// The dispersion of each law in its own words.
std::string dispersion_text(fragility::Law law)
{
    switch (law) {
    case fragility::Law::lognormal:
        break;
    case fragility::Law::normal:
        return "standard deviation of the drift";
    case fragility::Law::weibull:
        return "1 / shape of the Weibull law";
    case fragility::Law::gamma:
        return "coefficient of variation of the drift";
    }
    return "standard deviation of ln drift";
}

} // namespace

Table titled_table(std::string_view name, const Words& words)
{
    const std::string_view all = table_texts();
    const std::string opening = "\n== " + std::string(name) + "\n";
    const auto at = all.find(opening);
    if (at == std::string_view::npos)
        throw std::logic_error("table texts: no table " + std::string(name));
    std::string_view text = all.substr(at + opening.size());
    text = text.substr(0, text.find("\n=="));
    const auto title = text.find('\n');
    Table t;
    t.title = filled(text.substr(0, title), words);
    t.caption = filled(one_line(text.substr(title + 1)), words);
    return t;
}

Words words_of(const DriftData& data)
{
    std::string states;
    for (const StateName& s : data.states)
        states += (states.empty() ? "" : "; ") + state_name(s) + ": " + s.rule;
    return {{"counts", counts_text(data)},
            {"drift", data.drift},
            {"law", std::string(name(data.options.law))},
            {"confidence", percent_text(data.options.confidence)},
            {"states", states},
            {"dispersion", dispersion_text(data.options.law)},
            {"bootstrap", std::to_string(data.options.bootstrap)}};
}

Words words_of(const StudyWalls& walls)
{
    Words words = words_of(drift_data(walls));
    words["rule"] = mode_rule_text(walls.study.fragility);
    words["whatever"] = whatever_mode_text(walls.study.fragility);
    words["fall"] = percent_text(walls.study.fragility.ultimate_share);
    words["fallen"] = walls.study.fragility.mode.modes == dem::ModeRule::paper
                          ? " A wall whose force fell to " + words["fall"] +
                                " of its peak is mixed whatever the thresholds."
                          : "";
    words["ultimate"] = ultimate_text(walls.study.fragility);
    words["height"] = number(walls.height, 6);
    words["spatial"] = walls.study.uq.spatial == Spatial::none
                           ? ""
                           : " The values of the inputs vary from joint to joint.";
    return words;
}

} // namespace app
