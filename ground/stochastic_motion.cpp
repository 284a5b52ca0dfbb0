#include "ground/stochastic_motion.hpp"

#include "ground/call_arguments.hpp"
#include "ground/motion_facts.hpp"
#include "ground/oscillator.hpp"
#include "ground/record.hpp"
#include "ground/record_text.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace ground {
namespace {

constexpr std::string_view kName = "kanai_tajimi";
constexpr std::string_view kExample =
    "kanai_tajimi(peak 0.3 g, duration 20 s, seed 1, record 1)";
constexpr double kHighPassDamping = 0.6; // [-] Clough & Penzien 1975
constexpr double kEndShare = 0.05;       // of the envelope at the end of the noise
constexpr double kRiseShare = 0.1, kStrongShare = 0.4; // of the duration: choice
constexpr double kTail = 6.0; // decay times of the slower filter: 0.25 % is left
constexpr double kMostNoise = 1e6, kMostNumber = 1e9;

/// 64 random bits of a counter: the finaliser of SplitMix64 (Steele, Lea & Flood 2014), once
/// for each word.
std::uint64_t mixed(std::uint64_t x)
{
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/// In (0, 1).
double uniform(std::uint64_t bits) { return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52; }

/// Standard normal number `i` of a motion (Box & Muller 1958).
double normal(std::uint64_t key, std::uint64_t i)
{
    const double u = uniform(mixed(key ^ mixed(2 * i))),
                 v = uniform(mixed(key ^ mixed(2 * i + 1)));
    return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * std::numbers::pi * v);
}

double envelope(const KanaiTajimi& k, double t)
{
    if (t < k.rise) return t * t / (k.rise * k.rise);
    const double over = t - k.rise - k.strong, rest = k.duration - k.rise - k.strong;
    if (over <= 0.0) return 1.0;
    return t > k.duration ? 0.0 : std::exp(std::log(kEndShare) * over / rest);
}

/// Names what is not the default.
std::string text_of(const KanaiTajimi& k)
{
    const KanaiTajimi usual;
    std::string text = std::string(kName) + "(peak " + plain_text(k.peak / kGravity) + " g";
    const auto add = [&](const char* name, double value, double otherwise, const char* unit) {
        if (value != otherwise)
            text += std::string(", ") + name + " " + plain_text(value) + unit;
    };
    add("frequency", k.frequency, usual.frequency, " Hz");
    add("damping", k.damping, usual.damping, "");
    add("low", k.low_frequency, usual.low_frequency, " Hz");
    add("duration", k.duration, usual.duration, " s");
    add("rise", k.rise, kRiseShare * k.duration, " s");
    add("strong", k.strong, kStrongShare * k.duration, " s");
    add("step", k.step, usual.step, " s");
    return text + ", seed " + std::to_string(k.seed) + ", record " + std::to_string(k.record) +
           ")";
}

void check_stochastic(const KanaiTajimi& k)
{
    const auto require = [](bool ok, const char* what) {
        if (!ok) throw std::invalid_argument(std::string(kName) + ": " + what);
    };
    require(k.peak > 0 && k.frequency > 0 && k.low_frequency > 0 && k.step > 0,
            "peak, frequencies and step must be above 0");
    require(k.damping > 0 && k.damping < 1, "damping must be in (0, 1)");
    require(k.low_frequency < k.frequency, "low must be below frequency");
    require(k.rise > 0 && k.strong >= 0 && k.rise + k.strong < k.duration,
            "rise and strong together must be shorter than the duration; write e.g. duration "
            "20 s, rise 2 s, strong 8 s");
    require(k.step * k.frequency <= 0.1,
            "a step above a tenth of the period of the soil does not show it; make it smaller");
    require(k.duration / k.step <= kMostNoise,
            "duration and step make more than a million samples; make the step larger");
}

} // namespace

GroundMotion kanai_tajimi(const KanaiTajimi& k)
{
    check_stochastic(k);
    const double w = 2.0 * std::numbers::pi * k.frequency,
                 wl = 2.0 * std::numbers::pi * k.low_frequency;
    const auto noisy = static_cast<std::size_t>(std::ceil(k.duration / k.step));
    const auto tail =
        static_cast<std::size_t>(std::ceil(kTail / (kHighPassDamping * wl) / k.step));
    const std::uint64_t key = mixed(k.seed ^ mixed(k.record));
    Oscillator soil(w, k.damping, k.step), high_pass(wl, kHighPassDamping, k.step);
    GroundMotion m{text_of(k), k.step, {0.0}};
    double rock = 0.0, surface = 0.0; // accelerations at the start of the step
    for (std::size_t i = 1; i <= noisy + tail; ++i) {
        const double t = k.step * static_cast<double>(i);
        const double next = i <= noisy ? envelope(k, t) * normal(key, i) : 0.0;
        soil.advance(-rock, -next);
        rock = next;
        const double above = -(2.0 * k.damping * w * soil.v + w * w * soil.u);
        high_pass.advance(-surface, -above);
        surface = above;
        m.acceleration.push_back(-surface - 2.0 * kHighPassDamping * wl * high_pass.v -
                                 wl * wl * high_pass.u);
    }
    const double factor = k.peak / motion_facts(m).pga;
    return scaled(std::move(m), factor);
}

bool is_stochastic(std::string_view text)
{
    return text.find('(') != std::string_view::npos &&
           stripped(text.substr(0, text.find('('))) == kName;
}

std::vector<GroundMotion> stochastic_motions(std::string_view text)
{
    Arguments given(parse_call(text), std::string(kExample));
    constexpr double kMostPeak = 1000.0, kMostTime = 1000.0, kMostRecords = 10'000.0;
    KanaiTajimi k;
    const auto whole = [&](std::string_view name, double most) {
        const double x = given.take(name, Dimension::none, 1.0, most, 1.0);
        if (x != std::floor(x))
            throw std::invalid_argument(std::string(kName) + ": " + std::string(name) +
                                        " must be a whole number");
        return static_cast<std::uint64_t>(x);
    };
    k.peak = given.take("peak", Dimension::acceleration, 1e-6, kMostPeak);
    k.frequency = given.take("frequency", Dimension::frequency, 0.01, 100.0, k.frequency);
    k.damping = given.take("damping", Dimension::none, 0.0, 1.0, k.damping);
    k.low_frequency = given.take("low", Dimension::frequency, 0.01, 100.0, k.low_frequency);
    k.duration = given.take("duration", Dimension::time, 0.1, kMostTime, k.duration);
    k.rise = given.take("rise", Dimension::time, 1e-3, kMostTime, kRiseShare * k.duration);
    k.strong = given.take("strong", Dimension::time, 0.0, kMostTime, kStrongShare * k.duration);
    k.step = given.take("step", Dimension::time, 1e-5, 1.0, k.step);
    k.seed = whole("seed", kMostNumber);
    if (given.has("records") && given.has("record"))
        throw std::invalid_argument(
            std::string(kName) +
            ": write record for one of them, or records for as many, not both");
    const bool several = given.has("records");
    const std::uint64_t records = several ? whole("records", kMostRecords) : 1;
    if (!several) k.record = whole("record", kMostNumber);
    given.refuse_others();
    std::vector<GroundMotion> all;
    for (std::uint64_t i = 0; i < records; ++i) {
        if (several) k.record = i + 1;
        all.push_back(kanai_tajimi(k));
    }
    return all;
}

} // namespace ground
