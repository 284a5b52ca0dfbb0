#include "uq/designs/latin_annealing.hpp"

#include "uq/designs/design_criteria.hpp"
#include "uq/designs/stream.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace uq {
namespace {

constexpr double kPower = 50.0; // p of phi_p
constexpr double kLost = 1e-6;  // of a sum: what is less has lost its digits to larger terms

/// (scale / square)^(p/2): the term of a pair.
double term(double square, double scale)
{
    const double r = scale / square;
    const double r2 = r * r, r4 = r2 * r2, r8 = r4 * r4;
    return r8 * r8 * r8 * r;
}

struct Exchange {
    Eigen::Index a, b; ///< rows
    Eigen::Index j;    ///< variable
};

class Arrangement {
  public:
    explicit Arrangement(Eigen::MatrixXd u)
        : u_(std::move(u)), n_(u_.rows()), squares_(n_, n_), terms_(n_, n_), trial_(2 * n_),
          trial_terms_(2 * n_)
    {
        measure();
    }

    [[nodiscard]] const Eigen::MatrixXd& rows() const { return u_; }
    [[nodiscard]] double sum() const { return sum_; }

    /// All distances anew: what exchanges add up in rounding is gone.
    void measure()
    {
        sum_ = 0.0;
        scale_ = std::max(1e-12, std::pow(minimum_distance(u_), 2));
        for (Eigen::Index i = 0; i < n_; ++i)
            for (Eigen::Index k = 0; k < i; ++k) {
                const double square = std::max(1e-12, (u_.row(i) - u_.row(k)).squaredNorm());
                squares_(i, k) = squares_(k, i) = square;
                terms_(i, k) = terms_(k, i) = term(square, scale_);
                sum_ += terms_(i, k);
            }
    }

    /// Sum of the terms after the exchange, at least kLost of what it is; which is then ready
    /// to be done.
    double after(const Exchange& e)
    {
        const double xa = u_(e.a, e.j), xb = u_(e.b, e.j);
        const double *x = &u_(0, e.j), *da = &squares_(0, e.a), *db = &squares_(0, e.b);
        const double *ta = &terms_(0, e.a), *tb = &terms_(0, e.b);
        double change = 0.0;
        for (Eigen::Index i = 0; i < n_; ++i) {
            if (i == e.a || i == e.b) continue;
            const double shift = (xb - x[i]) * (xb - x[i]) - (xa - x[i]) * (xa - x[i]);
            trial_[i] = std::max(1e-12, da[i] + shift);
            trial_[n_ + i] = std::max(1e-12, db[i] - shift);
            trial_terms_[i] = term(trial_[i], scale_);
            trial_terms_[n_ + i] = term(trial_[n_ + i], scale_);
            change += (trial_terms_[i] - ta[i]) + (trial_terms_[n_ + i] - tb[i]);
        }
        return std::max(kLost * sum_, sum_ + change);
    }

    void exchange(const Exchange& e, double sum)
    {
        std::swap(u_(e.a, e.j), u_(e.b, e.j));
        for (Eigen::Index i = 0; i < n_; ++i) {
            if (i == e.a || i == e.b) continue;
            squares_(i, e.a) = squares_(e.a, i) = trial_[i];
            squares_(i, e.b) = squares_(e.b, i) = trial_[n_ + i];
            terms_(i, e.a) = terms_(e.a, i) = trial_terms_[i];
            terms_(i, e.b) = terms_(e.b, i) = trial_terms_[n_ + i];
        }
        if (sum < kLost * 10.0 * sum_)
            measure();
        else
            sum_ = sum;
    }

    /// ln phi, comparable over all measurements.
    [[nodiscard]] double ln_phi(double sum) const
    {
        return std::log(sum) / kPower - 0.5 * std::log(scale_);
    }

  private:
    Eigen::MatrixXd u_;
    Eigen::Index n_;
    Eigen::MatrixXd squares_, terms_; // of distances, whole matrices: rows are read in order
    Eigen::VectorXd trial_, trial_terms_;
    double scale_ = 1.0; ///< square of a distance: of the order of the smallest
    double sum_ = 0.0;
};

void check(Eigen::Index n, const AnnealingOptions& o)
{
    if (n > 4096)
        throw std::invalid_argument("optimised latin hypercube: rows are " + std::to_string(n) +
                                    "; allowed: at most 4096, use latin_random");
    if (o.exchanges < 0 || !(o.cold > 0.0 && o.cold <= o.hot && std::isfinite(o.hot)))
        throw std::invalid_argument("annealing: allowed are exchanges >= 0, 0 < cold <= hot");
}

Exchange draw(Stream& stream, Eigen::Index fixed, Eigen::Index n, Eigen::Index d)
{
    const auto free = static_cast<std::uint64_t>(n - fixed);
    const auto a = static_cast<Eigen::Index>(stream.below(free));
    auto b = static_cast<Eigen::Index>(stream.below(free - 1));
    if (b >= a) ++b;
    return {fixed + a, fixed + b,
            static_cast<Eigen::Index>(stream.below(static_cast<std::uint64_t>(d)))};
}

} // namespace

Eigen::MatrixXd spread_rows(Eigen::MatrixXd u, Eigen::Index fixed, std::uint64_t seed,
                            const AnnealingOptions& options)
{
    constexpr int kMeasureEvery = 500;
    const Eigen::Index n = u.rows();
    check(n, options);
    if (n - fixed < 2 || u.cols() < 2) return u;
    Stream stream(seed, static_cast<std::uint64_t>(n), Purpose::annealing);
    Arrangement now(std::move(u));
    Eigen::MatrixXd best = now.rows();
    double ln_phi = now.ln_phi(now.sum()), least = ln_phi;
    const double squared = static_cast<double>(n * n);
    const int descent = std::min<double>(options.exchanges, 6.0 * squared * best.cols());
    const double cooling = std::pow(options.cold / options.hot, 1.0 / (descent + 1.0));
    double temperature = 0.0;
    for (int i = 0; i < options.exchanges; ++i, temperature *= cooling) {
        if (i % descent == 0) temperature = options.hot / squared;
        if (i % kMeasureEvery == 0) {
            now.measure();
            ln_phi = now.ln_phi(now.sum());
        }
        const Exchange e = draw(stream, fixed, n, best.cols());
        const double sum = now.after(e);
        const double trial = now.ln_phi(sum);
        if (stream.uniform() >= std::exp((ln_phi - trial) / temperature)) continue;
        now.exchange(e, sum);
        ln_phi = now.ln_phi(now.sum());
        if (ln_phi < least) {
            least = ln_phi;
            best = now.rows();
        }
    }
    return best;
}

} // namespace uq
