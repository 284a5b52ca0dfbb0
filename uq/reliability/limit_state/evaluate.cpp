#include "uq/reliability/limit_state/evaluate.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <stdexcept>
#include <utility>

namespace uq {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Samples rows(const Samples& s, Eigen::Index first, Eigen::Index n)
{
    return {s.x.middleRows(first, n), {s.id.begin() + first, s.id.begin() + first + n}};
}

Responses failed_row(Eigen::Index columns, std::string reason)
{
    return {Eigen::MatrixXd::Constant(1, columns, kNan), {std::move(reason)}};
}

/// Empty if every value of the row is finite.
std::string not_finite(const Eigen::MatrixXd& y, Eigen::Index row)
{
    for (Eigen::Index j = 0; j < y.cols(); ++j)
        if (!std::isfinite(y(row, j)))
            return "response " + std::to_string(j) + " is " +
                   (std::isnan(y(row, j)) ? "not a number" : "infinite");
    return {};
}

/// Leaves only rows that are sound or marked as failed.
void mark_failures(Responses& r)
{
    for (Eigen::Index i = 0; i < r.y.rows(); ++i) {
        std::string& why = r.failure[static_cast<std::size_t>(i)];
        if (why.empty()) why = not_finite(r.y, i);
        if (!why.empty()) r.y.row(i).setConstant(kNan);
    }
}

std::string wrong_shape(const Responses& r, Eigen::Index n, Eigen::Index columns)
{
    if (r.y.rows() == n && std::cmp_equal(r.failure.size(), n) && r.y.cols() >= columns)
        return {};
    return "the model answers " + std::to_string(n) + " samples with " +
           std::to_string(r.y.rows()) + " rows, " + std::to_string(r.failure.size()) +
           " reasons and " + std::to_string(r.y.cols()) + " columns; " +
           std::to_string(columns) + " columns are needed";
}

/// Rows put under each other; columns that a row does not have are those of a failed row.
Responses one_by_one(const BlackBox& model, const Samples& samples, Eigen::Index columns)
{
    std::vector<Responses> parts;
    Eigen::Index widest = columns;
    for (Eigen::Index i = 0; i < samples.x.rows(); ++i) {
        parts.push_back(evaluate(model, rows(samples, i, 1), columns));
        widest = std::max(widest, parts.back().y.cols());
    }
    Responses all{Eigen::MatrixXd::Constant(samples.x.rows(), widest, kNan), {}};
    for (Eigen::Index i = 0; i < samples.x.rows(); ++i) {
        Responses& part = parts[static_cast<std::size_t>(i)];
        if (part.failure[0].empty() && part.y.cols() != widest)
            part.failure[0] = "the model answers with another number of columns than elsewhere";
        if (part.failure[0].empty()) all.y.row(i) = part.y.row(0);
        all.failure.push_back(std::move(part.failure[0]));
    }
    return all;
}

} // namespace

Responses evaluate(const BlackBox& model, const Samples& samples, Eigen::Index columns)
{
    const Eigen::Index n = samples.x.rows();
    if (!model) throw std::invalid_argument("model: there is no model to ask");
    if (!std::cmp_equal(samples.id.size(), n))
        throw std::invalid_argument("samples: " + std::to_string(n) + " rows but " +
                                    std::to_string(samples.id.size()) + " numbers");
    std::string why;
    try {
        Responses r = model(samples);
        why = wrong_shape(r, n, columns);
        if (why.empty()) {
            mark_failures(r);
            return r;
        }
    } catch (const std::exception& e) {
        why = std::string("exception: ") + e.what();
    }
    return n == 1 ? failed_row(columns, why) : one_by_one(model, samples, columns);
}

} // namespace uq
