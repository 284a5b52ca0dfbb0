#include "app/sampling/study_dependence.hpp"

#include "app/input/study/study.hpp"
#include "app/input/study/units.hpp"
#include "app/text/words.hpp"

#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace app {
namespace {

constexpr const char* kPearson = "uq.pearson";

[[noreturn]] void refuse(const StudyFile& source, const std::string& why)
{
    throw error_at(source, kPearson, why);
}

void check_pair(const Sampling& sampling, const StudyFile& source, Eigen::Index a,
                Eigen::Index b)
{
    if (a == b) refuse(source, "an input is paired with itself; name two");
    const Varies va = sampling.random[a].varies, vb = sampling.random[b].varies;
    if (sampling.uq.spatial == Spatial::stratified)
        refuse(source,
               "has no meaning with spatial = stratified; write independent or correlated");
    if (sampling.uq.spatial != Spatial::none && va != vb)
        refuse(source, "joins " + sampling.random[a].key + " and " + sampling.random[b].key +
                           ", which do not vary over the same joints; write spatial = none");
}

/// "joint.friction_angle joint.stiffness_factor 0.3"
void read_pair(const Sampling& sampling, const StudyFile& source, const std::string& item,
               Eigen::MatrixXd& r)
{
    std::istringstream in(item);
    std::string a, b, value, rest;
    in >> a >> b >> value;
    if (value.empty() || in >> rest)
        refuse(source, in_quotes(trimmed(item)) +
                           " is not two inputs and their correlation; write e.g. "
                           "\"joint.friction_angle joint.stiffness_factor 0.3\"");
    const auto i = static_cast<Eigen::Index>(input_named(sampling.random, source, a, kPearson)),
               j = static_cast<Eigen::Index>(input_named(sampling.random, source, b, kPearson));
    check_pair(sampling, source, i, j);
    if (r(i, j) != 0.0) refuse(source, a + " and " + b + " are given twice; keep one of them");
    r(i, j) = r(j, i) = read_at(source, kPearson, [&] { return parse_quantity(value, ""); });
}

} // namespace

std::size_t input_named(const std::vector<RandomInput>& random, const StudyFile& source,
                        std::string_view word, const char* key)
{
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < random.size(); ++i) {
        if (random[i].key == word) return i;
        names.push_back(random[i].key);
    }
    throw error_at(source, key,
                   in_quotes(word) + " is not a random input of this study; " +
                       (names.empty() ? "there is none" : suggestion(word, names)));
}

std::optional<uq::NormalCopula> dependence_of(const Sampling& sampling, const StudyFile& source)
{
    if (sampling.uq.pearson.empty()) return {};
    const auto n = static_cast<Eigen::Index>(sampling.random.size());
    std::vector<uq::Variable> variables;
    for (const RandomInput& r : sampling.random) variables.push_back({r.key, r.marginal});
    Eigen::MatrixXd pearson = Eigen::MatrixXd::Identity(n, n);
    std::istringstream list(sampling.uq.pearson);
    for (std::string item; std::getline(list, item, ',');)
        read_pair(sampling, source, item, pearson);
    return read_at(source, kPearson, [&] { return uq::normal_copula(variables, pearson); });
}

} // namespace app
