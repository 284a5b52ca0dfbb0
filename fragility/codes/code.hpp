#pragma once
/// Codes for the assessment of walls as data: limit states, drift limits, where they stand.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fragility {

/// Point of a curve that a limit state is read at.
enum class CodePart {
    none,          ///< its drift limit alone
    yield,         ///< of the equal-energy bilinear
    yield_or_peak, ///< the yield, or the peak if it comes first
    peak,          ///< displacement at the peak
    ultimate,      ///< fall of the force to a share of the peak
    collapse,      ///< no force left, or the wall came down
    rise,          ///< first rise to a share of the peak
    drop,          ///< drop to a share after the peak
    state          ///< another limit state of the code
};

/// A drift, or a drift times H0 / D. H0 is the distance from the section where the flexural
/// capacity is attained to the contraflexure point, D the in-plane depth of the wall.
struct CodeDrift {
    double drift = 0.0; ///< [-], > 0
    bool by_slenderness = false;
};

struct CodeState {
    std::string name; ///< "SLC"
    CodePart part = CodePart::none;
    double factor = 1.0;     ///< of the part [-], > 0; of rise and drop the share
    std::string factor_text; ///< as written: "3/4"; empty: 1
    std::string of_name;     ///< the limit state that part == state names
    int of = -1;             ///< its index
    double times = 1.0;      ///< on all drifts [-], > 0
    /// Drift limits by mode: "rocking", "sliding", "mixed", and "other" for modes not named.
    std::vector<std::pair<std::string, CodeDrift>> drifts;
    std::string source, article, remark;
    /// Reason of a displacement that is its drift limit. Outlives every reading.
    std::string_view governs;
};

struct Code {
    std::string name; ///< as in study files: "ntc"
    std::string title;
    std::vector<CodeState> states; ///< mildest first; empty: nothing is given here
    std::string missing;           ///< what the code says beyond, or does not say
};

/// Drift limit of a wall, or of a pier.
/// @param mode "rocking"
/// @param slenderness H0 / D [-], > 0
/// @return [-]; 0: the state has none for this mode
[[nodiscard]] double drift_limit(const CodeState& state, std::string_view mode,
                                 double slenderness);

/// Whether any of its limit states has a drift limit.
[[nodiscard]] bool limits_drift(const Code& code);

/// "Circolare 7/2019, C8.7.1.3.1.1"
[[nodiscard]] std::string source_text(const CodeState& state);

/// "a drift of 1 % if the wall rocks, 0.5 % if not"; empty: it has none.
/// @param slenderness H0 / D [-]; 0: not known
[[nodiscard]] std::string drift_text(const CodeState& state, double slenderness);

/// 0.8 -> "80 %", 2/3 -> "66.67 %"
[[nodiscard]] std::string percent(double share);

} // namespace fragility
