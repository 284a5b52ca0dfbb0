#include "app/reliability/event.hpp"

#include "app/input/study/units.hpp"
#include "app/reading/wall_numbers.hpp"

#include "app/text/words.hpp"

#include <algorithm>
#include <sstream>

namespace app {

uq::ReliabilityProblem asked_problem(const UqInput& uq, const ReliabilityInput& reliability,
                                     const StudyFile& source, Eigen::Index dimension)
{
    uq::ReliabilityProblem p;
    p.event.dimension = dimension;
    p.method = reliability.method;
    p.budget = reliability.budget;
    p.target_cov = reliability.target_cov;
    p.seed = uq.seed;
    if (const std::string why = uq::budget_too_small(p.method, p.budget, dimension);
        !why.empty())
        throw error_at(source, "reliability.budget", why);
    if (p.method == ReliabilityMethod::sobol && !uq.together.empty())
        throw error_at(source, "uq.together",
                       "inputs whose values stand row by row depend on each other, and Sobol' "
                       "indices are of independent ones; remove it");
    if (p.method == ReliabilityMethod::sobol && !uq.pearson.empty())
        throw error_at(
            source, "uq.pearson",
            "has no meaning for reliability.method = sobol: Sobol' indices are shares "
            "of independent inputs; leave it out");
    return p;
}

namespace {

bool asks_program(const ProgramInput& program) { return !program.command.empty(); }

/// "joint.friction_angle" has the values "joint.friction_angle.17".
bool is_value_of(const RandomInput& input, const std::string& name)
{
    return name == input.key ||
           (name.starts_with(input.key + ".") &&
            name.find_first_not_of("0123456789", input.key.size() + 1) == std::string::npos);
}

ShownNumber shown_input(const RandomInput& input, const std::string& name)
{
    if (input.unit.empty()) return {name + " [-]", 1.0};
    return {name + " [" + std::string(input.unit) + "]", from_si(1.0, input.unit)};
}

} // namespace

std::vector<ShownNumber> shown_inputs(const ProgramInput& program,
                                      const std::vector<RandomInput>& random,
                                      const std::vector<std::string>& names)
{
    std::vector<ShownNumber> all;
    for (const std::string& name : names) {
        const auto input = std::ranges::find_if(
            random, [&](const RandomInput& r) { return is_value_of(r, name); });
        const bool known = input != random.end() && !asks_program(program);
        all.push_back(known ? shown_input(*input, name) : ShownNumber{name, 1.0});
    }
    return all;
}

ShownNumber shown_response(const ReliabilityInput& reliability, const ProgramInput& program,
                           const uq::ReliabilityProblem& problem)
{
    if (!asks_program(program)) {
        const WallNumber& r = kWallNumbers.at(reliability.response);
        return {std::string(r.name) + " [" + std::string(r.unit.name) + "]", r.unit.scale};
    }
    std::istringstream names(program.responses);
    std::string name;
    for (Eigen::Index i = 0; i <= problem.event.response; ++i) std::getline(names, name, ',');
    return {std::string(trimmed(name)), 1.0};
}

} // namespace app
