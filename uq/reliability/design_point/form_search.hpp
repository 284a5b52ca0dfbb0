#pragma once
/// Searches for a design point: the point of g(u) = 0 nearest to the origin. Two that share
/// nothing but the gradient, so that one can be checked by the other.

#include "uq/reliability/design_point/form_search_gradient.hpp"

namespace uq {

enum class SearchMethod {
    improved_hl_rf, ///< Zhang and Der Kiureghian (1995)
    slsqp,          ///< Kraft (1988), of NLopt: min |u|^2 / 2 with g(u) = 0
    cobyla          ///< Powell (1994), of NLopt: the same without gradients; for rough g
};

enum class SearchOutcome {
    converged,
    iterations_used_up,
    evaluation_failed, ///< the model gave no answer at a point that was needed
    flat,              ///< zero gradient: no direction to go
    no_descent,        ///< the line search finds no better point
    off_surface,       ///< it stopped where g is not zero
    off_axis           ///< it stopped on g = 0, at a point that is not nearest to the origin
};

struct SearchOptions {
    double step = 1e-3;       ///< of central differences, in u; wider where g is rough, (0, 1]
    double on_surface = 1e-6; ///< accepted distance from g = 0 [standard deviations], > 0
    double on_axis = 1e-4;    ///< accepted off_axis() [standard deviations], > 0
    int max_iterations = 100; ///< of improved HL-RF, and evaluations of g of NLopt / 10; >= 1
};

/// @throws std::invalid_argument naming the option
void check(const SearchOptions& o);

struct DesignPoint {
    LinearLimit at;        ///< u, g and its gradient
    Eigen::VectorXd alpha; ///< unit vector towards g < 0
    /// Signed distance from the origin to the plane: alpha u + g / |gradient|. Negative if the
    /// origin has passed the limit state.
    double beta;
};

struct Search {
    SearchMethod method = SearchMethod::improved_hl_rf;
    Eigen::VectorXd start;
    SearchOutcome outcome = SearchOutcome::iterations_used_up;
    std::string reason;               ///< of not having converged, with the numbers reached
    std::optional<DesignPoint> point; ///< only if converged
    int iterations = 0;               ///< gradients (values for cobyla) taken
    std::size_t evaluations = 0;
};

[[nodiscard]] std::string_view name(SearchMethod m);

/// u <- u + lambda (u_HL-RF - u), lambda halved until the merit |u|^2 / 2 + c |g| falls enough.
/// The full step is evaluated with its gradient in one batch; shorter ones, needed seldom, all
/// in a second.
[[nodiscard]] Search search_hl_rf(const LimitState& s, const Eigen::VectorXd& start,
                                  const SearchOptions& o, Ledger& ledger);

/// @param method slsqp or cobyla
[[nodiscard]] Search search_constrained(const LimitState& s, const Eigen::VectorXd& start,
                                        SearchMethod method, const SearchOptions& o,
                                        Ledger& ledger);

/// Accepts `l` as design point of `search` or says why not. Both searches end here.
void judge(const LinearLimit& l, const SearchOptions& o, Search& search);

/// Ends a search without a point.
void give_up(Search& search, SearchOutcome outcome, std::string reason);

/// Ends a search that has no value at a point: the model failed there, or no evaluation was
/// left.
/// @param where "at the start"
void give_up_without_value(Search& search, const Ledger& ledger, const std::string& where);

} // namespace uq
