#pragma once
/// Limit states of a wall, as sets of displacements read off its capacity curve. The sets ntc
/// and ec8 also take the drift limits of their codes; behaviour-factor caps are not applied.

#include "fragility/bilinear.hpp"
#include "fragility/curve_reading.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fragility {

/// Drifts of existing masonry at SLC: of a wall that rocks (flexure), and of one that slides or
/// cracks (shear). Circolare 7/2019, C8.7.1.3.1.1; 0.004, of modern hollow blocks alone, is
/// left out.
constexpr double kNtcRockingDrift = 0.010, kNtcShearDrift = 0.005; ///< [-]

/// Drifts of primary walls at SD: of a wall that bends, times H0 / D, and of one in shear. EN
/// 1998-3:2005, Annex C, C.4.2 and C.4.3. H0 is the distance from the section where the
/// flexural capacity is attained to the contraflexure point, D the in-plane depth of the wall.
/// The drifts at NC are 4/3 of these.
constexpr double kEc8FlexureDrift = 0.008, kEc8ShearDrift = 0.004; ///< [-]

/// Drift limit at SLC.
[[nodiscard]] constexpr double ntc_drift(bool rocks)
{
    return rocks ? kNtcRockingDrift : kNtcShearDrift;
}

/// Drift limit at NC.
/// @param slenderness H0 / D [-], > 0
[[nodiscard]] constexpr double ec8_drift(bool rocks, double slenderness)
{
    return 4.0 / 3.0 * (rocks ? kEc8FlexureDrift * slenderness : kEc8ShearDrift);
}

/// Reasons of a displacement that is a drift limit: of a code, or one that the user gave.
constexpr std::string_view
    kNtcLimitGoverns = "governed by the code's drift limit",
    kEc8LimitGoverns = "governed by the drift limit of EN 1998-3, Annex C; compare with your "
                       "copy of the code",
    kGivenLimitGoverns = "the largest displacement allowed";

/// Whether a displacement is such a limit, or a share of one, and not the wall's own.
[[nodiscard]] bool is_capped(const LimitDisplacement& d);

/// Free choices of the reading; the defaults are those of the codes.
struct LimitStateOptions {
    double ultimate_share = kUltimateShare; ///< of the peak [-], in (0, 1)
    Crossing crossing = Crossing::first;    ///< of that share
    double bilinear_share = kBilinearShare; ///< of the peak [-], in (0, 1]
    double ntc_limit = 0.0;   ///< of the displacement at SLC, set ntc [length]; 0: none
    double ec8_limit = 0.0;   ///< of the displacement at NC, set ec8 [length]; 0: none
    double slenderness = 0.0; ///< H0 / D behind ec8_limit [-], for the words of its rule
    /// Distance at which the force was zero before the start of the curve [length], >= 0: the
    /// yield is counted from there (fragility/cyclic_curve.hpp).
    double residual = 0.0;
    std::string_view no_yield = {}; ///< why the curve has none; empty: it has
    /// Displacement up to which the curve is that of first loading, which has the stiffness of
    /// the yield [length]; 0: all of it.
    double reach = 0.0;
};

struct LimitState {
    std::string_view name; ///< as in its code: "SLV"
    std::string rule;      ///< how it is read, with the numbers used: "3/4 of SLC"
    LimitDisplacement limit;
};

/// Names of the sets, as in study files.
[[nodiscard]] std::span<const std::string_view> limit_state_sets();

/// The limit states of a set, mildest first.
///   paper  ultimate = displacement where the force falls to 80 % of the peak (the paper,
///   section 4.2)
///   ntc    SLC = min(ultimate, ntc_limit), SLV = 3/4 SLC, SLD = min(d_y, d at the peak), SLO =
///   2/3 SLD, on the
///          curve up to SLC (Circolare 7/2019, C8.7.1.3.1, existing masonry)
///   ec8    NC = min(ultimate, ec8_limit), SD = 3/4 NC, DL = d_y, on the curve up to NC (EN
///   1998-3:2005, Annex C)
///   collapse  no force is left after the peak, or the wall came down
/// with d_y the yield displacement of the equal-energy bilinear up to the ultimate
/// displacement. The code's second condition for SLD, "all piers of a storey at their peak, not
/// before 3/4 of the peak base shear", is the displacement at the peak for one wall.
///
/// Where ultimate is censored, 3/4 of it is censored too, and so is d_y, which moves with where
/// the push ends: however the push goes on, d_y is at least the smaller of that up to the end
/// and ultimate_share of the peak over the stiffness. On a brittle curve SLD may come after
/// SLV: they are reported as the rules give them.
/// @throws std::invalid_argument as check(), for shares out of range and a set that is not
/// known
[[nodiscard]] std::vector<LimitState> read_limit_states(const Curve& curve,
                                                        std::string_view set,
                                                        const LimitStateOptions& options = {});

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
/// @return names refer to `states`
/// @throws std::invalid_argument as check(), for shares out of range, and for a state without
/// rule or
/// with several, naming it
[[nodiscard]] std::vector<LimitState> read_limit_states(const Curve& curve,
                                                        std::span<const UserLimitState> states,
                                                        const LimitStateOptions& options = {});

} // namespace fragility
