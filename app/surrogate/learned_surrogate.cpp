#include "app/surrogate/learned_surrogate.hpp"

#include "app/input/keys/key_values.hpp"
#include "app/input/study/units.hpp"
#include "app/study/stored/stress_text.hpp"
#include "app/surrogate/surrogate_output.hpp"
#include "app/text/config_error.hpp"
#include "app/text/json_text.hpp"
#include "app/text/text_file.hpp"
#include "app/text/words.hpp"

#include <cmath>
#include <stdexcept>

namespace app {
namespace {

constexpr std::size_t kMostSurrogateBytes = 64 << 20;

/// Damage of the file, without its place.
struct Damage : std::runtime_error {
    using std::runtime_error::runtime_error;
};

Eigen::VectorXd vector_at(const Json& object, const char* key)
{
    const auto values = object.at(key).get<std::vector<double>>();
    return Eigen::Map<const Eigen::VectorXd>(values.data(),
                                             static_cast<Eigen::Index>(values.size()));
}

template <class Matrix>
Matrix matrix_at(const Json& object, const char* key, std::size_t columns)
{
    const Json& rows = object.at(key);
    Matrix m(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(columns));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].size() != columns)
            throw Damage(std::string(key) + ": a row has " + std::to_string(rows[i].size()) +
                         " numbers, and must have " + std::to_string(columns));
        for (std::size_t j = 0; j < columns; ++j)
            m(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
                rows[i][j].get<typename Matrix::Scalar>();
    }
    return m;
}

/// The family that the file names. One of an earlier version has Legendre for beta variables.
uq::PolynomialFamily learned_family(const std::string& text, const std::string& key,
                                    const uq::Marginal& marginal)
{
    const uq::PolynomialFamily family = uq::family_named(text);
    const bool linear = family.kind == uq::PolynomialFamily::jacobi ||
                        family.kind == uq::PolynomialFamily::laguerre;
    if (linear && family != uq::family_of(marginal))
        throw Damage(key + ": coordinate " + in_quotes(text) + " is not of its distribution");
    return family;
}

LearnedInput learned_input(const Json& j)
{
    const std::string name = j.at("key");
    const Key* const key = find_key(name);
    if (key == nullptr) throw Damage(name + ": is not a key of this version");
    const std::string text = j.at("distribution");
    const std::optional<RandomInput> random = parse_random(*key, text);
    if (!random) throw Damage(name + ": " + in_quotes(text) + " is no distribution");
    return {name, j.at("unit"), key->unit.empty() ? 1.0 : from_si(1.0, key->unit),
            random->marginal, learned_family(j.at("coordinate"), name, random->marginal)};
}

uq::ProcessKernel kernel_at(const Json& process)
{
    const std::string wanted = process.at("kernel");
    for (const auto kernel : {uq::ProcessKernel::matern_32, uq::ProcessKernel::matern_52,
                              uq::ProcessKernel::squared_exponential})
        if (uq::name(kernel) == wanted) return kernel;
    throw Damage("kernel: " + wanted + " is not one of this version");
}

void read_process(const Json& j, std::size_t inputs, LearnedLevel& level)
{
    if (!j.contains("responses"))
        throw Damage("responses: there are none: the file is of an earlier version; run "
                     "drystone surrogate again");
    level.process = uq::condition(
        {matrix_at<Eigen::MatrixXd>(j, "points", inputs), vector_at(j, "responses")},
        kernel_at(j), uq::ProcessTrend::constant,
        {j.at("variance"), vector_at(j, "lengths"), j.at("noise"),
         j.contains("noise_slopes") ? vector_at(j, "noise_slopes") : Eigen::VectorXd()});
    level.inflation = j.contains("inflation")
                          ? j["inflation"].get<double>()
                          : uq::inflation_of(uq::leave_one_out(*level.process));
    if (!(level.inflation >= 1.0 && std::isfinite(level.inflation)))
        throw Damage("inflation: must be 1 or more");
}

void read_chaos(const Json& j, const std::vector<LearnedInput>& inputs, LearnedLevel& level)
{
    uq::PolynomialChaos chaos;
    for (const LearnedInput& in : inputs) chaos.families.push_back(in.family);
    chaos.degrees = matrix_at<Eigen::MatrixXi>(j, "degrees", inputs.size());
    chaos.coefficients = vector_at(j, "coefficients");
    if (chaos.coefficients.size() != chaos.degrees.rows())
        throw Damage("coefficients: there must be one for each row of degrees");
    level.chaos = std::move(chaos);
}

/// In SI.
Eigen::VectorXd range_at(const Json& level, const char* end,
                         const std::vector<LearnedInput>& inputs)
{
    Eigen::VectorXd x = vector_at(level.at("learned_between"), end);
    if (x.size() != static_cast<Eigen::Index>(inputs.size()))
        throw Damage("learned_between: there must be one value for each input");
    for (std::size_t k = 0; k < inputs.size(); ++k)
        x(static_cast<Eigen::Index>(k)) /= inputs[k].scale;
    return x;
}

/// Files of an earlier version have no modes.
std::optional<LearnedModes> learned_modes(const Json& level, std::size_t inputs)
{
    if (!level.contains("modes") || !level["modes"].contains("coefficients")) return {};
    const Json& j = level["modes"];
    LearnedModes m;
    m.names = j.at("names").get<std::vector<std::string>>();
    m.doubts = j.at("doubts").get<std::vector<std::string>>();
    m.model.outcome = fragility::ModelOutcome::converged;
    m.model.coefficients = matrix_at<Eigen::MatrixXd>(j, "coefficients", 1 + inputs);
    const auto size = static_cast<std::size_t>(m.model.coefficients.size());
    m.model.covariance = matrix_at<Eigen::MatrixXd>(j, "covariance", size);
    if (m.names.size() < 2 ||
        m.model.coefficients.rows() + 1 != static_cast<Eigen::Index>(m.names.size()) ||
        m.model.covariance.rows() != m.model.covariance.cols())
        throw Damage("modes: names, coefficients and covariance do not fit together");
    return m;
}

LearnedLevel learned_level(const Json& j, const std::vector<LearnedInput>& inputs)
{
    LearnedLevel level;
    level.stress = j.at("vertical_stress_MPa").get<double>() * 1e6;
    level.doubts = j.at("doubts").get<std::vector<std::string>>();
    level.modes = learned_modes(j, inputs.size());
    if (j.at("better").is_null()) return level;
    level.least = range_at(j, "least", inputs);
    level.most = range_at(j, "most", inputs);
    const std::string better = j.at("better");
    const Json& learned = j.at(better);
    level.rmse = learned.at("error").at("rmse");
    if (better == "chaos")
        read_chaos(learned, inputs, level);
    else
        read_process(learned, inputs.size(), level);
    return level;
}

LearnedSurrogate learned(const Json& j)
{
    const std::string format = j.is_object() ? j.value("format", "") : "";
    if (format != kSurrogateFormat && format != kNewerSurrogateFormat)
        throw Damage("is not a surrogate; give the surrogate.json that drystone surrogate "
                     "FILE.h5 wrote");
    LearnedSurrogate s;
    s.study = j.at("study");
    s.study_sum = j.value("study_sum", "");
    s.response = j.at("response");
    s.unit = j.at("unit");
    s.scale = surrogate_response(s.response).unit.scale;
    for (const Json& in : j.at("inputs")) s.inputs.push_back(learned_input(in));
    for (const Json& level : j.at("surrogates"))
        s.levels.push_back(learned_level(level, s.inputs));
    return s;
}

} // namespace

bool is_surrogate_file(std::string_view path) { return path.ends_with(".json"); }

LearnedSurrogate read_surrogate(const std::string& path)
{
    const std::string text =
        read_bytes(path, kMostSurrogateBytes, "is larger than 64 MiB, and no surrogate",
                   "give the surrogate.json that drystone surrogate FILE.h5 wrote");
    try {
        LearnedSurrogate s = learned(json_of(text));
        s.path = path;
        return s;
    } catch (const Json::exception& bad) {
        throw ConfigError(path, 0, "", std::string("is damaged: ") + bad.what());
    } catch (const std::exception& bad) { // Damage, BadValue, std::invalid_argument
        throw ConfigError(path, 0, "", bad.what());
    }
}

Eigen::MatrixXd surrogate_coordinates(const LearnedSurrogate& s, const Eigen::MatrixXd& x)
{
    const auto d = static_cast<Eigen::Index>(s.inputs.size());
    if (x.cols() != d)
        throw BadValue("a wall has " + std::to_string(d) + " inputs, and " +
                       std::to_string(x.cols()) + " are given");
    Eigen::MatrixXd c(x.rows(), d);
    for (Eigen::Index k = 0; k < d; ++k) {
        const LearnedInput& in = s.inputs[static_cast<std::size_t>(k)];
        for (Eigen::Index i = 0; i < x.rows(); ++i) {
            if (!std::isfinite(x(i, k))) throw BadValue(in.key + ": must be a finite number");
            c(i, k) = uq::coordinate(in.family, in.marginal, x(i, k));
        }
    }
    return c;
}

SurrogateAnswers predict(const LearnedSurrogate& s, const LearnedLevel& level,
                         const Eigen::MatrixXd& x)
{
    if (!level.chaos && !level.process)
        throw std::runtime_error(level.doubts.empty() ? "there is no surrogate of this stress"
                                                      : level.doubts.front());
    const Eigen::MatrixXd c = surrogate_coordinates(s, x);
    SurrogateAnswers a;
    if (level.chaos) {
        a.mean = uq::predict(*level.chaos, c);
        a.sd = Eigen::VectorXd::Constant(c.rows(), level.rmse);
    } else {
        const uq::ProcessPrediction p = uq::predict(*level.process, c);
        a.mean = p.mean;
        a.sd = (level.inflation *
                (p.variance + uq::noise_at(level.process->parameters, c)).array())
                   .sqrt();
    }
    a.mean /= s.scale;
    a.sd /= s.scale;
    a.outside = Eigen::VectorXi::Zero(c.rows());
    // values were written to twelve digits
    constexpr double kRounding = 1e-9;
    for (Eigen::Index i = 0; i < x.rows(); ++i)
        for (Eigen::Index k = 0; k < x.cols(); ++k) {
            const double room = kRounding * (level.most(k) - level.least(k));
            a.outside(i) +=
                x(i, k) < level.least(k) - room || x(i, k) > level.most(k) + room ? 1 : 0;
        }
    return a;
}

ModeAnswers predict_modes(const LearnedSurrogate& s, const LearnedLevel& level,
                          const Eigen::MatrixXd& x)
{
    if (!level.modes)
        throw std::runtime_error("there are no modes of " + stress_text(level.stress));
    const Eigen::MatrixXd c = surrogate_coordinates(s, x);
    const auto modes = static_cast<Eigen::Index>(level.modes->names.size());
    ModeAnswers a{Eigen::MatrixXd(c.rows(), modes), Eigen::MatrixXd(c.rows(), modes)};
    for (Eigen::Index i = 0; i < c.rows(); ++i)
        for (Eigen::Index k = 0; k < modes; ++k) {
            const auto p = fragility::mode_probability(level.modes->model, static_cast<int>(k),
                                                       c.row(i).transpose());
            a.probability(i, k) = p.value;
            a.sd(i, k) = std::isfinite(p.std_error) ? p.std_error : 0.0; // a certain mode
        }
    return a;
}

} // namespace app
