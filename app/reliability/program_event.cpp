#include "app/input/distribution_text.hpp"
#include "app/input/study_keys.hpp"
#include "app/input/units.hpp"
#include "app/input/words.hpp"
#include "app/reliability/event.hpp"
#include "app/reliability/methods.hpp"
#include "app/study/interrupt.hpp"
#include "uq/designs/normal_copula.hpp"
#include "uq/reliability/external_program.hpp"

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace app {
namespace {

constexpr std::array<std::string_view, 13> kKnown = {
    "model.command",      "model.responses",    "model.concurrent",
    "model.time_limit",   "model.retries",      "uq.seed",
    "uq.pearson",         "reliability.method", "reliability.response",
    "reliability.demand", "reliability.budget", "reliability.target_cov",
    "reliability.event"};

/// Reads one value; errors get their place.
template <class Read> auto at(const StudyFile& file, const std::string& key, Read read)
{
    try {
        return read(find_entry(file, key)->value);
    } catch (const BadValue& bad) {
        throw error_at(file, key, bad.what());
    } catch (const std::invalid_argument& bad) {
        throw error_at(file, key, bad.what());
    }
}

std::string text_of(const StudyFile& file, const std::string& key, const std::string& example)
{
    if (const Entry* e = find_entry(file, key)) return e->value;
    throw error_at(file, key, "missing; write e.g. \"" + example + "\"");
}

double number_of(const StudyFile& file, const std::string& key, double otherwise, double least,
                 double most)
{
    if (find_entry(file, key) == nullptr) return otherwise;
    const double x = at(file, key, [](const std::string& v) { return parse_quantity(v, ""); });
    if (x < least || x > most) throw error_at(file, key, "is out of range");
    return x;
}

int count_of(const StudyFile& file, const std::string& key, int otherwise)
{
    if (find_entry(file, key) == nullptr) return otherwise;
    const double x = at(file, key, [](const std::string& v) { return parse_count(v); });
    if (x < 0 || x > 1e8) throw error_at(file, key, "must be in [0, 1e8]");
    return static_cast<int>(x);
}

/// Words between blanks; quotes hold blanks together.
std::vector<std::string> words_of(const StudyFile& file, const std::string& text)
{
    std::vector<std::string> words;
    std::string word;
    bool quoted = false, any = false;
    for (const char c : text) {
        if (c == '"') {
            quoted = !quoted;
            any = true;
        } else if ((c == ' ' || c == '\t') && !quoted) {
            if (any) words.push_back(std::exchange(word, {}));
            any = false;
        } else {
            word += c;
            any = true;
        }
    }
    if (quoted) throw error_at(file, "model.command", "a quote is not closed");
    if (any) words.push_back(word);
    return words;
}

void refuse_unknown(const StudyFile& file)
{
    for (const Entry& e : file.entries) {
        if (section_of(e.key) == "variables") continue;
        if (std::find(kKnown.begin(), kKnown.end(), e.key) == kKnown.end())
            throw error_at(file, e.key,
                           "unknown key of a study of another program; " +
                               suggestion(e.key, kKnown));
    }
}

std::vector<uq::Variable> inputs_of(const StudyFile& file)
{
    std::vector<uq::Variable> inputs;
    for (const Entry& e : file.entries) {
        if (section_of(e.key) != "variables") continue;
        const uq::Marginal m = at(file, e.key, [](const std::string& v) {
            return is_distribution(v) ? parse_distribution(v, "")
                                      : uq::Marginal{uq::Constant{parse_quantity(v, "")}};
        });
        inputs.push_back({std::string(name_in_section(e.key)), m});
    }
    if (inputs.empty())
        throw error_at(
            file, "variables.name",
            "no variable; write e.g. \"friction = normal(mean 31.8, cov 0.20)\" under "
            "[variables], in the units of the program");
    return inputs;
}

ReliabilityMethod method_of(const StudyFile& file)
{
    const Entry* e = find_entry(file, "reliability.method");
    if (e == nullptr) return ReliabilityMethod::monte_carlo;
    const Key& key = *find_key("reliability.method");
    for (const Named& n : key.names)
        if (n.word == e->value && e->value != "multi_fidelity")
            return static_cast<ReliabilityMethod>(static_cast<int>(n.value));
    throw error_at(file, e->key,
                   in_quotes(e->value) +
                       " is none of monte_carlo, form, importance, subset and sobol");
}

uq::Map map_of(const StudyFile& file, const std::vector<uq::Variable>& inputs)
{
    if (find_entry(file, "uq.pearson") != nullptr)
        throw error_at(file, "uq.pearson", "not read for another program in this version");
    return [inputs](const Eigen::MatrixXd& u) {
        Eigen::MatrixXd x = u;
        for (std::size_t j = 0; j < inputs.size(); ++j)
            for (double& value : x.col(static_cast<Eigen::Index>(j)))
                value = uq::from_normal(inputs[j].marginal, value);
        return x;
    };
}

uq::ExternalProgram program_of(const StudyFile& file, const std::vector<uq::Variable>& inputs,
                               int threads)
{
    uq::ExternalProgram p;
    p.command =
        words_of(file, text_of(file, "model.command", "command = ./model {input} {output}"));
    std::istringstream names(text_of(file, "model.responses", "responses = capacity"));
    for (std::string name; std::getline(names, name, ',');)
        p.responses.emplace_back(trimmed(name));
    for (const uq::Variable& v : inputs) p.parameters.push_back(v.name);
    p.concurrent = count_of(file, "model.concurrent", threads);
    p.retries = count_of(file, "model.retries", 0);
    p.while_waiting = [] {
        if (interrupted()) throw Interrupted();
    };
    if (const Entry* e = find_entry(file, "model.time_limit"))
        p.time_limit =
            at(file, e->key, [](const std::string& v) { return parse_quantity(v, "s"); });
    return p;
}

} // namespace

bool is_external(const StudyFile& file)
{
    return std::any_of(file.sections.begin(), file.sections.end(),
                       [](const SectionHeader& s) { return s.name == "model"; });
}

ReliabilityProblem external_problem(const StudyFile& file, const Command& command)
{
    refuse_unknown(file);
    const std::vector<uq::Variable> inputs = inputs_of(file);
    const uq::ExternalProgram program = program_of(file, inputs, command.threads);
    ReliabilityProblem p;
    p.event.to_physical = map_of(file, inputs);
    p.event.dimension = static_cast<Eigen::Index>(inputs.size());
    const Entry* response = find_entry(file, "reliability.response");
    const std::string name = response != nullptr ? response->value : program.responses.front();
    const auto found = std::find(program.responses.begin(), program.responses.end(), name);
    if (found == program.responses.end())
        throw error_at(file, "reliability.response",
                       in_quotes(name) + " is none of model.responses");
    p.event.response = found - program.responses.begin();
    (void)text_of(file, "reliability.demand", "demand = 40");
    p.event.threshold = number_of(file, "reliability.demand", 0.0, -1e300, 1e300);
    const Entry* event = find_entry(file, "reliability.event");
    if (event != nullptr && event->value != "below" && event->value != "above")
        throw error_at(file, event->key, in_quotes(event->value) + " is not below or above");
    const bool above = event != nullptr && event->value == "above";
    p.event.passing = above ? uq::Passing::at_or_above : uq::Passing::at_or_below;
    p.words = name + (above ? " >= " : " <= ") + find_entry(file, "reliability.demand")->value;
    for (const uq::Variable& v : inputs) p.inputs.push_back(v.name);
    p.normal = p.inputs;
    p.method = method_of(file);
    p.budget = count_of(file, "reliability.budget", p.budget);
    if (const std::string why = too_small(p.method, p.budget, p.event.dimension); !why.empty())
        throw error_at(file, "reliability.budget", why);
    p.target_cov = number_of(file, "reliability.target_cov", p.target_cov, 1e-6, 10.0);
    p.seed = static_cast<std::uint64_t>(count_of(file, "uq.seed", 1));
    try {
        p.event.model = uq::external_model(program);
    } catch (const std::invalid_argument& bad) {
        throw error_at(file, "model.command", bad.what());
    }
    return p;
}

} // namespace app
