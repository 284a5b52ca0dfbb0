#include "uq/surrogates/process_kernel.hpp"

#include <cmath>

namespace uq {

std::string_view name(ProcessKernel kernel)
{
    switch (kernel) {
    case ProcessKernel::matern_32:
        return "Matern 3/2";
    case ProcessKernel::matern_52:
        return "Matern 5/2";
    case ProcessKernel::squared_exponential:
        break;
    }
    return "squared exponential";
}

double process_correlation(ProcessKernel kernel, double r2)
{
    if (kernel == ProcessKernel::squared_exponential) return std::exp(-0.5 * r2);
    const bool rough = kernel == ProcessKernel::matern_32;
    const double a = std::sqrt((rough ? 3.0 : 5.0) * r2);
    return (rough ? 1.0 + a : 1.0 + a + a * a / 3.0) * std::exp(-a);
}

double process_slope(ProcessKernel kernel, double r2)
{
    if (kernel == ProcessKernel::squared_exponential) return std::exp(-0.5 * r2);
    const bool rough = kernel == ProcessKernel::matern_32;
    const double a = std::sqrt((rough ? 3.0 : 5.0) * r2);
    return (rough ? 3.0 : 5.0 / 3.0 * (1.0 + a)) * std::exp(-a);
}

Eigen::VectorXd scaled_distances(const Eigen::MatrixXd& scaled, const Eigen::RowVectorXd& point)
{
    Eigen::VectorXd r2 = Eigen::VectorXd::Zero(scaled.rows());
    for (Eigen::Index k = 0; k < scaled.cols(); ++k)
        r2.array() += (scaled.col(k).array() - point(k)).square();
    return r2;
}

} // namespace uq
