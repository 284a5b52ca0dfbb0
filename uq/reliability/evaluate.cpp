#include "uq/reliability/evaluate.hpp"

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
Responses one_by_one(const Model& model, const Samples& samples, Eigen::Index columns)
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

Model by_rows(RowFunction f, Eigen::Index responses)
{
    if (!f) throw std::invalid_argument("model: there is no function to ask");
    if (responses < 1)
        throw std::invalid_argument("model: responses is " + std::to_string(responses) +
                                    ", must be at least 1");
    return [f = std::move(f), responses](const Samples& s) {
        const auto n = static_cast<std::size_t>(s.x.rows());
        Responses r{Eigen::MatrixXd::Constant(s.x.rows(), responses, kNan),
                    std::vector<std::string>(n)};
        for (Eigen::Index i = 0; i < s.x.rows(); ++i) {
            std::string& why = r.failure[static_cast<std::size_t>(i)];
            try {
                const Eigen::VectorXd y = f(s.x.row(i).transpose());
                if (y.size() == responses)
                    r.y.row(i) = y.transpose();
                else
                    why = "the model gives " + std::to_string(y.size()) +
                          " values instead of " + std::to_string(responses);
            } catch (const std::exception& e) {
                why = std::string("exception: ") + e.what();
            }
        }
        mark_failures(r);
        return r;
    };
}

Model in_batches(Model model, Eigen::Index size)
{
    if (!model) throw std::invalid_argument("model: there is no model to ask");
    if (size < 1)
        throw std::invalid_argument("model: batch size is " + std::to_string(size) +
                                    ", must be at least 1");
    return [model = std::move(model), size](const Samples& s) {
        const Eigen::Index n = s.x.rows();
        Responses all{Eigen::MatrixXd(n, 0), {}};
        for (Eigen::Index first = 0; first < n; first += size) {
            const Eigen::Index count = std::min(size, n - first);
            Responses part = evaluate(model, rows(s, first, count));
            if (first == 0) all.y = Eigen::MatrixXd::Constant(n, part.y.cols(), kNan);
            const Eigen::Index known = all.y.cols();
            if (part.y.cols() > known) {
                all.y.conservativeResize(n, part.y.cols());
                all.y.rightCols(part.y.cols() - known).setConstant(kNan);
            }
            all.y.block(first, 0, count, part.y.cols()) = part.y;
            all.failure.insert(all.failure.end(), part.failure.begin(), part.failure.end());
        }
        mark_failures(all);
        return all;
    };
}

Responses evaluate(const Model& model, const Samples& samples, Eigen::Index columns)
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

std::size_t count_failed(const Responses& r)
{
    return static_cast<std::size_t>(
        std::ranges::count_if(r.failure, [](const std::string& why) { return !why.empty(); }));
}

} // namespace uq
