#include "uq/reliability/limit_state/kept_evaluations.hpp"

#include "uq/reliability/limit_state/evaluate.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

namespace uq {
namespace {

namespace fs = std::filesystem;

using Json = nlohmann::json;

constexpr std::size_t kAtOnce = 32; ///< samples that a kill may lose

/// Bytes that are not UTF-8, which a reason may quote, become the replacement character.
std::string as_line(const Json& j)
{
    return j.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// The model that the first line of a file states; empty if it states none.
std::string model_in(const std::string& line)
{
    const Json j = Json::parse(line, nullptr, false);
    return j.is_object() && j.contains("model") && j["model"].is_string()
               ? j["model"].get<std::string>()
               : "";
}

} // namespace

KeptEvaluations::KeptEvaluations(fs::path file, const std::string& model)
    : file_(std::move(file))
{
    std::ifstream in(file_);
    std::string line;
    std::uintmax_t sound = 0; // bytes of whole lines
    const bool begun = in && std::getline(in, line) && !in.eof();
    if (begun) {
        if (line + "\n" != as_line({{"model", model}}))
            throw OtherModel("'" + file_.string() + "' holds the evaluations of another model",
                             model_in(line));
        sound = line.size() + 1;
        while (std::getline(in, line) && !in.eof()) {
            try {
                const Json j = Json::parse(line);
                const Json& y = j.at("y");
                known_[j.at("x").get<std::vector<double>>()] = {
                    y.is_null() ? std::numeric_limits<double>::quiet_NaN() : y.get<double>(),
                    j.at("why").get<std::string>()};
            } catch (const Json::exception&) {
                throw std::runtime_error(
                    "'" + file_.string() +
                    "' is damaged; remove it: its evaluations are made again");
            }
            sound += line.size() + 1;
        }
    }
    in.close();
    found_ = known_.size();
    if (begun) fs::resize_file(file_, sound);
    out_.open(file_, begun ? std::ios::app : std::ios::trunc);
    if (!begun) out_ << as_line({{"model", model}}) << std::flush;
    if (!out_) throw std::runtime_error("cannot write '" + file_.string() + "'");
}

void KeptEvaluations::keep(const std::vector<double>& x, const Answer& a)
{
    out_ << as_line(
        {{"why", a.failure}, {"x", x}, {"y", a.failure.empty() ? Json(a.y) : Json(nullptr)}});
    known_[x] = a;
}

BlackBox KeptEvaluations::around(BlackBox model, Eigen::Index response)
{
    return [this, model = std::move(model), response](const Samples& samples) {
        const auto row = [&](Eigen::Index i) {
            const Eigen::VectorXd x = samples.x.row(i);
            return std::vector<double>(x.begin(), x.end());
        };
        std::vector<Eigen::Index> fresh;
        for (Eigen::Index i = 0; i < samples.x.rows(); ++i)
            if (!known_.contains(row(i))) fresh.push_back(i);
        for (std::size_t first = 0; first < fresh.size(); first += kAtOnce) {
            const std::size_t n = std::min(kAtOnce, fresh.size() - first);
            const std::vector<Eigen::Index> part(fresh.begin() + static_cast<long>(first),
                                                 fresh.begin() + static_cast<long>(first + n));
            Samples few{samples.x(part, Eigen::all), {}};
            for (const Eigen::Index i : part) few.id.push_back(samples.id[i]);
            const Responses r = evaluate(model, few, response + 1);
            for (std::size_t k = 0; k < n; ++k)
                keep(row(part[k]), {r.y(static_cast<Eigen::Index>(k), response), r.failure[k]});
            if (!out_.flush()) throw NotKept{"cannot write '" + file_.string() + "'"};
        }
        Responses all{Eigen::MatrixXd(samples.x.rows(), 1), {}};
        for (Eigen::Index i = 0; i < samples.x.rows(); ++i) {
            const Answer& a = known_.at(row(i));
            all.y(i, 0) = a.y;
            all.failure.push_back(a.failure);
        }
        return all;
    };
}

void KeptEvaluations::remove()
{
    out_.close();
    fs::remove(file_);
}

} // namespace uq
