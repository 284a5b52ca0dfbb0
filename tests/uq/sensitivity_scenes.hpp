#pragma once
/// Functions on the unit cube whose Sobol' indices are known.

#include <Eigen/Core>

#include <cmath>
#include <vector>

namespace scenes {

/// Ishigami and Homma (1990), a = 7, b = 0.1; x in (-pi, pi).
inline Eigen::VectorXd ishigami(const Eigen::MatrixXd& u)
{
    const Eigen::ArrayXXd x = M_PI * (2.0 * u.array() - 1.0);
    return x.col(0).sin() + 7.0 * x.col(1).sin().square() +
           0.1 * x.col(2).pow(4) * x.col(0).sin();
}

/// mean 3.5, variance 13.8445879407193
inline const std::vector<double> kIshigamiFirst{.313905191147811, .442411144790041, 0.0};
inline const std::vector<double> kIshigamiTotal{.557588855209959, .442411144790041,
                                                .243683664062148};

/// Product of (|4 u_i - 2| + a_i) / (1 + a_i) (Saltelli and Sobol' 1995).
inline Eigen::VectorXd g_function(const Eigen::MatrixXd& u, const std::vector<double>& a)
{
    Eigen::ArrayXd y = Eigen::ArrayXd::Ones(u.rows());
    for (Eigen::Index i = 0; i < u.cols(); ++i) {
        const double ai = a[static_cast<std::size_t>(i)];
        y *= ((4.0 * u.col(i).array() - 2.0).abs() + ai) / (1.0 + ai);
    }
    return y;
}

} // namespace scenes
