#include "fragility/intensity/crossed_design.hpp"

#include "core/fit_factors.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace fragility {

VarianceSplit variance_split(const Eigen::MatrixXd& y)
{
    const auto r = static_cast<double>(y.rows()), w = static_cast<double>(y.cols());
    if (r < 2.0 || w < 2.0 || !y.allFinite())
        throw std::invalid_argument(
            "a crossed design needs two records and two walls or more, and finite values");
    VarianceSplit s;
    s.mean = y.mean();
    const Eigen::VectorXd by_record = y.rowwise().mean();
    const Eigen::RowVectorXd by_wall = y.colwise().mean();
    const double of_records = w * (by_record.array() - s.mean).square().sum() / (r - 1.0);
    const double of_walls = r * (by_wall.array() - s.mean).square().sum() / (w - 1.0);
    const Eigen::MatrixXd rest =
        (y.colwise() - by_record).rowwise() - (by_wall.array() - s.mean).matrix();
    const double left = rest.squaredNorm() / ((r - 1.0) * (w - 1.0));
    s.records = (of_records - left) / w;
    s.walls = (of_walls - left) / r;
    s.interaction = left;
    s.total = s.records + s.walls + s.interaction;
    // of the mean: records / r + walls / w + interaction / (r w)
    const double square = (of_records + of_walls - left) / (r * w);
    const double least =
        std::max(of_records, of_walls) / (r * w); // never less than either alone
    s.mean_error = std::sqrt(std::max(square, least));
    const double sum = std::max(square, least) * r * w;
    s.freedom = sum * sum /
                (of_records * of_records / (r - 1.0) + of_walls * of_walls / (w - 1.0) +
                 (square > least ? left * left / ((r - 1.0) * (w - 1.0)) : 0.0));
    s.freedom = std::max(s.freedom, 1.0);
    return s;
}

core::Interval mean_interval(const VarianceSplit& split, double confidence)
{
    const double half = split.mean_error * core::fit_student_factor(confidence, split.freedom);
    return {split.mean - half, split.mean + half, confidence};
}

} // namespace fragility
