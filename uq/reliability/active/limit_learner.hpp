#pragma once
/// A Gaussian process of a limit state that grows with what is known.

#include "uq/surrogates/gaussian_process.hpp"

#include <optional>

namespace uq {

/// The process is of g as it is, or of asinh(g / scale), which keeps its sign and makes large
/// values small, whichever is likelier. It is fitted anew when a seventh more is known than at
/// the last fit; from 200 points on its parameters stay, and 600 points are all that it has:
/// the cost of both grows with the cube.
class Learner {
  public:
    /// Adds evaluations; those that gave no answer (NaN) are left out.
    void learn(const Eigen::MatrixXd& u, const Eigen::VectorXd& g);

    /// The process of g - shift.
    /// @throws std::invalid_argument where nothing can be learned
    [[nodiscard]] const GaussianProcess& process(double shift = 0.0);

    /// The last process sees asinh((g - shift) / scale); infinite: g - shift.
    [[nodiscard]] double scale() const { return scale_; }

    [[nodiscard]] const Eigen::VectorXd& values() const { return g_; }
    [[nodiscard]] Eigen::Index known() const { return g_.size(); }
    [[nodiscard]] bool full() const;
    [[nodiscard]] bool passed() const { return passed_; } ///< whether g <= 0 was ever seen

  private:
    void fit(const Eigen::VectorXd& g);

    Eigen::MatrixXd u_;
    Eigen::VectorXd g_;
    bool passed_ = false;
    std::optional<GaussianProcess> last_;
    double scale_ = 0.0;
    Eigen::Index fitted_ = 0; ///< points of the last fit
};

} // namespace uq
