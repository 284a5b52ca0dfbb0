#pragma once
/// Limit states of a wall, as sets of displacements read off its capacity curve. The sets of
/// codes are data (fragility/codes/codes.json), with the drift limits of their codes;
/// behaviour-factor caps are not applied.

#include "fragility/codes/code.hpp"
#include "fragility/curve/bilinear.hpp"
#include "fragility/curve/curve_reading.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fragility {

/// Reason of a displacement that is a limit that the user gave.
constexpr std::string_view kGivenLimitGoverns = "the largest displacement allowed";

/// Whether a displacement is such a limit, or a drift limit of a code, or a share of one, and
/// not the wall's own.
[[nodiscard]] bool is_capped(const LimitDisplacement& d);

/// Free choices of the reading; the defaults are those of the codes.
struct LimitStateOptions {
    double ultimate_share = kUltimateShare; ///< of the peak [-], in (0, 1)
    Crossing crossing = Crossing::first;    ///< of that share
    double bilinear_share = kBilinearShare; ///< of the peak [-], in (0, 1]
    double slenderness = 0.0; ///< H0 / D [-], for the words of rules; 0: not known
    /// Distance at which the force was zero before the start of the curve [length], negative
    /// after it: the yield is counted from there (fragility/curve/cyclic_curve.hpp).
    double residual = 0.0;
    std::string_view no_yield = {}; ///< why the curve has none; empty: it has
    /// Displacement up to which the curve is that of first loading, which has the stiffness of
    /// the yield [length]; 0: all of it.
    double reach = 0.0;
};

struct LimitState {
    std::string name; ///< as in its code: "SLV"
    std::string rule; ///< how it is read, with the numbers used: "3/4 of SLC"
    LimitDisplacement limit;
};

/// The limit states of a code, mildest first.
///
/// Yield and peak are those of the curve up to the drift limit of the limit state whose rule is
/// `ultimate`, where it comes before the fall of the force; with any other rule a drift limit
/// cuts off that limit state alone. The yield is that of the equal-energy bilinear up to the
/// ultimate displacement.
///
/// Where ultimate is censored, 3/4 of it is censored too, and so is the yield, which moves with
/// where the push ends: however the push goes on, it is at least the smaller of that up to the
/// end and ultimate_share of the peak over the stiffness. On a brittle curve the yield may come
/// after 3/4 of ultimate: they are reported as the rules give them.
/// @param caps displacements at the drift limits, by limit state [length]; 0, or no list: none
/// @throws std::invalid_argument as check(), for shares out of range, and for a code without
/// limit states
[[nodiscard]] std::vector<LimitState> read_limit_states(const Curve& curve, const Code& code,
                                                        std::span<const double> caps,
                                                        const LimitStateOptions& options = {});

/// Yield and ultimate displacement of a curve, without drift limits.
struct CurveParts {
    LimitDisplacement yield, ultimate;
};
[[nodiscard]] CurveParts curve_parts(const Curve& curve, const LimitStateOptions& options = {});

/// A limit state of the user: weights times displacements of the curve, or a share of the peak
/// force, or a cap on the displacement; with a cap beside another rule, whichever comes first.
struct UserLimitState {
    std::string name;
    double yield = 0.0;         ///< weight of d_y [-], >= 0
    double peak = 0.0;          ///< weight of the displacement at the peak [-], >= 0
    double ultimate = 0.0;      ///< weight of d_u [-], >= 0
    std::optional<double> rise; ///< first rise to this share of the peak force [-], in (0, 1]
    std::optional<double> drop; ///< drop to this share after the peak [-], in (0, 1)
    std::optional<double> at_most; ///< [length], > 0
};

/// Only the weights, only `rise` or only `drop`, or none of them and `at_most`. A sum is
/// censored where a part is: at the sum of what the parts are known to exceed.
/// @throws std::invalid_argument as check(), for shares out of range, and for a state without
/// rule or
/// with several, naming it
[[nodiscard]] std::vector<LimitState> read_limit_states(const Curve& curve,
                                                        std::span<const UserLimitState> states,
                                                        const LimitStateOptions& options = {});

} // namespace fragility
