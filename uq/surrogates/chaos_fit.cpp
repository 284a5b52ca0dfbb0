#include "uq/surrogates/chaos_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace uq {

namespace {

constexpr double kNothingLeft =
    1e-10; // of the square of a candidate: it is a combination of chosen terms
constexpr double kExact = 1e-28;        // error at which the path ends
constexpr double kMostTermShare = 0.34; // terms over samples: more follow the noise; choice
constexpr int kPatience = 2; // degrees without gain after which no higher one is tried

/// The best length of a path through one set.
struct ChaosPath {
    std::vector<Eigen::Index> terms; ///< columns of the set, as they were chosen
    Eigen::VectorXd coefficients;
    Eigen::VectorXd residual;                               ///< leave-one-out
    double error = std::numeric_limits<double>::infinity(); ///< corrected mean square
};

/// State of a path: chosen terms are q r, q of orthonormal columns.
struct ChaosSelection {
    Eigen::MatrixXd left;  ///< candidates without their part in the chosen terms
    Eigen::VectorXd first; ///< squares of the candidates
    Eigen::VectorXd residual;
    Eigen::VectorXd leverage;
    Eigen::MatrixXd r, inverse; ///< of the chosen columns, upper
    Eigen::VectorXd projection; ///< q' y
    std::vector<Eigen::Index> terms;
    double trace = 0.0; ///< tr((A' A)^-1)
};

/// The candidate that takes most off the residual; -1: none can.
Eigen::Index next_term(const ChaosSelection& s)
{
    Eigen::Index best = -1;
    double most = 0.0;
    for (Eigen::Index j = 0; j < s.left.cols(); ++j) {
        const double square = s.left.col(j).squaredNorm();
        if (!(square > kNothingLeft * s.first(j))) continue;
        const double along = s.left.col(j).dot(s.residual);
        if (along * along / square > most) {
            most = along * along / square;
            best = j;
        }
    }
    return best;
}

void take_term(ChaosSelection& s, const Eigen::MatrixXd& candidates, const Eigen::MatrixXd& q,
               Eigen::Index j, Eigen::VectorXd& direction)
{
    const auto n = static_cast<Eigen::Index>(s.terms.size());
    direction = candidates.col(j);
    Eigen::VectorXd column = Eigen::VectorXd::Zero(n);
    for (int pass = 0; pass < 2; ++pass) { // twice is enough (Giraud, Langou, Rozloznik 2005)
        const Eigen::VectorXd along = q.leftCols(n).transpose() * direction;
        direction -= q.leftCols(n) * along;
        column += along;
    }
    const double pivot = direction.norm();
    direction /= pivot;
    s.r.col(n).head(n) = column;
    s.r(n, n) = pivot;
    s.inverse.col(n).head(n) = -(s.inverse.topLeftCorner(n, n) * column) / pivot;
    s.inverse(n, n) = 1.0 / pivot;
    s.trace += s.inverse.col(n).head(n + 1).squaredNorm();
    s.projection(n) = direction.dot(s.residual);
    s.residual -= s.projection(n) * direction;
    s.leverage.array() += direction.array().square();
    s.left -= direction * (direction.transpose() * s.left);
    s.left.col(j).setZero();
    s.terms.push_back(j);
}

ChaosPath best_path(const Eigen::MatrixXd& candidates, const Eigen::VectorXd& y)
{
    const Eigen::Index n = y.size();
    const auto most = std::max<Eigen::Index>(
        1, std::min(candidates.cols(),
                    static_cast<Eigen::Index>(kMostTermShare * static_cast<double>(n))));
    ChaosSelection s{candidates,
                     candidates.colwise().squaredNorm(),
                     y,
                     Eigen::VectorXd::Zero(n),
                     Eigen::MatrixXd::Zero(most, most),
                     Eigen::MatrixXd::Zero(most, most),
                     Eigen::VectorXd::Zero(most),
                     {},
                     0.0};
    Eigen::MatrixXd q(n, most);
    Eigen::VectorXd direction;
    ChaosPath best;
    const double scale = (y.array() - y.mean()).square().mean();
    std::size_t since = 0;
    while (static_cast<Eigen::Index>(s.terms.size()) < most) {
        const Eigen::Index j = s.terms.empty() ? 0 : next_term(s); // the constant comes first
        if (j < 0) break;
        take_term(s, candidates, q, j, direction);
        const auto terms = static_cast<Eigen::Index>(s.terms.size());
        q.col(terms - 1) = direction;
        const Eigen::ArrayXd room = 1.0 - s.leverage.array();
        if (!(room.minCoeff() > 1e-9)) break; // a sample that the terms follow blindly
        const Eigen::VectorXd out = s.residual.array() / room;
        const auto count = static_cast<double>(n);
        const double correction =
            count / (count - static_cast<double>(terms)) * (1.0 + s.trace);
        const double error = out.squaredNorm() / count * correction;
        ++since;
        if (error < best.error) {
            since = 0;
            best.error = error;
            best.terms = s.terms;
            best.residual = out;
            best.coefficients =
                s.inverse.topLeftCorner(terms, terms) * s.projection.head(terms);
        }
        if (error <= kExact * scale || since > 10 + best.terms.size() / 4) break;
    }
    return best;
}

ChaosFit fit_of(const std::vector<PolynomialFamily>& families, const Eigen::MatrixXi& set,
                const ChaosPath& path, int degree, double norm, double scale)
{
    ChaosFit fit{{families,
                  Eigen::MatrixXi(static_cast<Eigen::Index>(path.terms.size()), set.cols()),
                  path.coefficients},
                 degree,
                 norm,
                 path.residual,
                 path.error / scale};
    for (std::size_t t = 0; t < path.terms.size(); ++t)
        fit.chaos.degrees.row(static_cast<Eigen::Index>(t)) = set.row(path.terms[t]);
    return fit;
}

void check_chaos(const std::vector<PolynomialFamily>& families, const Eigen::MatrixXd& c,
                 const Eigen::VectorXd& y, const ChaosFitOptions& o)
{
    const auto refuse = [](bool wrong, const char* why) {
        if (wrong) throw std::invalid_argument(why);
    };
    refuse(c.rows() != y.size() || c.cols() != static_cast<Eigen::Index>(families.size()) ||
               c.cols() < 1,
           "chaos: one row of coordinates for each response, one column for each input");
    refuse(y.size() < 3, "chaos: at least 3 samples");
    refuse(!c.allFinite() || !y.allFinite(), "chaos: coordinates and responses must be finite");
    refuse(o.most_degree < 1 || o.norms.empty() || o.most_terms < 1, "chaos: nothing to try");
    for (const double q : o.norms)
        refuse(!(q > 0.0 && q <= 1.0), "chaos: the norm of a hyperbolic set is in (0, 1]");
    refuse(!(y.maxCoeff() > y.minCoeff()), "chaos: the response does not vary");
}

} // namespace

ChaosFit fit_chaos(const std::vector<PolynomialFamily>& families, const Eigen::MatrixXd& c,
                   const Eigen::VectorXd& y, const ChaosFitOptions& o)
{
    check_chaos(families, c, y, o);
    const double scale = (y.array() - y.mean()).square().mean();
    ChaosFit best;
    best.corrected_error = std::numeric_limits<double>::infinity();
    for (const double q : o.norms) {
        double least = std::numeric_limits<double>::infinity();
        Eigen::Index last = 0;
        int idle = 0;
        for (int degree = 1; degree <= o.most_degree && idle < kPatience; ++degree) {
            const Eigen::MatrixXi set = hyperbolic_set(static_cast<int>(c.cols()), degree, q);
            if (set.rows() > o.most_terms && degree > 1) break;
            if (set.rows() == last) continue;
            last = set.rows();
            const ChaosPath path = best_path(chaos_terms(families, set, c), y);
            idle = path.error < least ? 0 : idle + 1;
            least = std::min(least, path.error);
            if (path.error / scale < best.corrected_error)
                best = fit_of(families, set, path, degree, q, scale);
        }
    }
    if (!std::isfinite(best.corrected_error))
        throw std::invalid_argument("chaos: too few samples");
    return best;
}

Eigen::VectorXd held_out_residuals(const ChaosFit& fit, const Eigen::MatrixXd& c,
                                   const Eigen::VectorXd& y, int folds)
{
    const Eigen::MatrixXi set =
        hyperbolic_set(static_cast<int>(c.cols()), fit.degree, fit.norm);
    const Eigen::MatrixXd terms = chaos_terms(fit.chaos.families, set, c);
    Eigen::VectorXd residual(y.size());
    for (int fold = 0; fold < folds; ++fold) {
        std::vector<Eigen::Index> in, out;
        for (Eigen::Index i = 0; i < y.size(); ++i) (i % folds == fold ? out : in).push_back(i);
        const ChaosPath path = best_path(terms(in, Eigen::all), y(in));
        for (const Eigen::Index i : out) {
            residual(i) = y(i);
            for (std::size_t t = 0; t < path.terms.size(); ++t)
                residual(i) -=
                    path.coefficients(static_cast<Eigen::Index>(t)) * terms(i, path.terms[t]);
        }
    }
    return residual;
}

} // namespace uq
