#include "dem/shaking/free_vibration.hpp"

#include <algorithm>
#include <cmath>

namespace dem {

namespace {

constexpr long long kLeastWindows = 5;
constexpr double kWindow = 1.0; // [s]
// Against the motion that is borne (choices): a swing of two thousandths of the height, or of a
// hundredth where three seconds tell its middle, about a place that is the same within three
// hundred thousandths, where a ten thousandth is borne.
constexpr double kSwing = 20.0, kLongSwing = 100.0, kShift = 0.3;
constexpr std::size_t kLong = 3; // [windows]

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

FreeVibration::Window FreeVibration::together(std::size_t windows, std::size_t after) const
{
    Window all = ended_[ended_.size() - after - 1];
    for (std::size_t i = 1; i < windows; ++i) {
        const Window& w = ended_[ended_.size() - after - 1 - i];
        all.sum += w.sum;
        all.least = std::min(all.least, w.least);
        all.most = std::max(all.most, w.most);
        all.counted += w.counted;
    }
    return all;
}

bool FreeVibration::stays(std::size_t windows, double swing, double shift) const
{
    if (ended_.size() < 2 * windows) return false;
    const Window last = together(windows, 0), before = together(windows, windows);
    return last.most - last.least <= swing &&
           std::abs(mean_of(last) - mean_of(before)) <= shift;
}

bool FreeVibration::quiet(const ShakingClock& clock, double borne)
{
    const bool ends = length_ > 0 && clock.step != clock.last && clock.step - from_ >= length_;
    if (!ends) return false;
    ended_.push_back(now_);
    if (borne > 0.0) {
        const bool rests = now_.most - now_.least <= borne;
        if (rests || stays(1, kSwing * borne, kShift * borne)) return true;
        if (stays(kLong, kLongSwing * borne, kShift * borne)) {
            now_ = together(kLong, 0);
            return true;
        }
    }
    now_ = {};
    from_ = clock.step + 1;
    return false;
}

} // namespace dem
