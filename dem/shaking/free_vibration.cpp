#include "dem/shaking/free_vibration.hpp"

#include <algorithm>
#include <cmath>

namespace dem {

namespace {

constexpr long long kLeastWindows = 5;
constexpr double kWindow = 1.0; // [s]
// Against the motion that is borne (choices): a swing of two thousandths of the height about a
// place that is the same within three hundred thousandths, where a ten thousandth is borne.
constexpr double kSwing = 20.0, kShift = 0.3;

long long windows_of(const ShakingClock& clock)
{
    const double time = static_cast<double>(clock.last - clock.record) * clock.dt;
    return std::max(kLeastWindows, std::llround(time / kWindow));
}

} // namespace

FreeVibration::FreeVibration(const ShakingClock& clock)
    : length_((clock.last - clock.record) / windows_of(clock)),
      from_(clock.last - windows_of(clock) * length_)
{
}

void FreeVibration::add(const ShakingClock& clock, double top)
{
    if (clock.step < from_) return;
    now_.least = any() ? std::min(now_.least, top) : top;
    now_.most = any() ? std::max(now_.most, top) : top;
    now_.sum += top;
    ++now_.counted;
}

bool FreeVibration::quiet(const ShakingClock& clock, double borne)
{
    const bool ends = length_ > 0 && clock.step != clock.last && clock.step - from_ >= length_;
    if (!ends) return false;
    const double swing = now_.most - now_.least;
    const bool rests = swing <= borne;
    const bool stays = before_.counted > 0 && swing <= kSwing * borne &&
                       std::abs(mean() - mean_of(before_)) <= kShift * borne;
    if (borne > 0.0 && (rests || stays)) return true;
    before_ = now_;
    now_ = {};
    from_ = clock.step + 1;
    return false;
}

} // namespace dem
