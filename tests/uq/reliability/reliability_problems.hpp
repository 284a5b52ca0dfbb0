#pragma once
/// Published limit states of structural reliability, as maps from standard normal variables.

#include "uq/reliability/limit_state/evaluate.hpp"
#include "uq/reliability/limit_state/limit_state.hpp"

#include <functional>
#include <string>
#include <vector>

namespace problems {

struct Problem {
    std::string name;
    uq::LimitState limit;
    double exact; ///< probability, by quadrature to about 1e-10
    double beta;  ///< of the nearest design point; of RP8 by OpenTURNS 1.20, to 1e-8
};

using G = std::function<double(const Eigen::VectorXd&)>;

/// A model of one column that asks `f` row by row.
uq::BlackBox by_rows(G f);

/// Rows without an answer.
std::size_t count_failed(const uq::Responses& r);

/// g(x) <= 0 over x = u, one row at a time.
uq::LimitState limit_state(Eigen::Index dimension, G g, uq::Map map = {});

Problem difference_4_2();    ///< R - S, N(4, 1), N(2, 1)
Problem difference_7_2();    ///< Waarts (2000)
Problem four_branch();       ///< Waarts (2000)
Problem rp22();              ///< otbenchmark: a paraboloid
Problem axial_beam();        ///< OpenTURNS
Problem rp8();               ///< otbenchmark
Problem portal_frame();      ///< Dakota
Problem steel_section();     ///< Dakota
Problem log_ratio(double z); ///< Dakota: x1 / x2 < z; `exact` in closed form

/// Each of the above; the log ratio at 0.4.
std::vector<Problem> all();

/// g = radius - |u_1|: two design points, P = 2 Phi(-radius).
uq::LimitState two_sided(double radius);

/// `limit`, but the model throws where `fails(x)`.
uq::LimitState failing(uq::LimitState limit, std::function<bool(const Eigen::VectorXd&)> fails);

} // namespace problems
