#pragma once
/// The top of a wall after the record: where it comes to lie, and when nothing comes of it any
/// more.
///
/// The free vibration is looked at in windows of a second, or of a fifth of its longest time if
/// that is shorter. It is quiet after a window in which the top has hardly moved, after one in
/// which it swings a little about the same place as in the window before, and after three in
/// which it swings more about the same place as in the three before. Joints hardly damp the
/// lowest frequencies of a wall, so that such a swing lasts for minutes and changes nothing.

#include "dem/shaking/shaking_clock.hpp"

#include <cstddef>
#include <vector>

namespace dem {

class FreeVibration {
  public:
    FreeVibration() = default;
    explicit FreeVibration(const ShakingClock& clock);

    /// Takes the place of the top [m] at this step of the clock.
    void add(const ShakingClock& clock, double top);

    /// Whether the wall is quiet with the window that ends at this step; else the next one
    /// begins where this one has ended.
    /// @param borne motion of the top in a window [m]; 0: never quiet
    [[nodiscard]] bool quiet(const ShakingClock& clock, double borne);

    [[nodiscard]] bool any() const { return now_.counted > 0; }
    /// Mean place of the top in the window at hand, or in the three that ended quietly [m]; of
    /// any().
    [[nodiscard]] double mean() const { return mean_of(now_); }

  private:
    struct Window {
        double sum = 0.0, least = 0.0, most = 0.0; ///< over its steps [m]
        long long counted = 0;
    };
    [[nodiscard]] static double mean_of(const Window& window)
    {
        return window.sum / static_cast<double>(window.counted);
    }
    /// Windows that have ended, as one, and how many of them the last ones leave out.
    [[nodiscard]] Window together(std::size_t windows, std::size_t after) const;
    /// Whether the top swings by no more than this about one place in the last windows and in
    /// as many before [m].
    [[nodiscard]] bool stays(std::size_t windows, double swing, double shift) const;

    long long length_ = 0, from_ = 0; ///< of a window; where the one at hand begins [steps]
    Window now_;
    std::vector<Window> ended_;
};

} // namespace dem
