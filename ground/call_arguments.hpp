#pragma once
/// Arguments of a text such as `half_sine(peak 0.5 g, duration 0.3 s)`, taken out by name.
/// Internal to ground/.

#include "ground/call_text.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace ground {

/// Takes values out of a call by name, and refuses those that are left.
class Arguments {
  public:
    /// @param example the call as it should be written, for messages
    Arguments(CallText call, std::string example)
        : call_(std::move(call)), example_(std::move(example))
    {
    }

    [[nodiscard]] bool has(std::string_view name) const;

    /// @throws std::invalid_argument if it is missing without `otherwise`, or out of range
    double take(std::string_view name, Dimension dimension, double least, double most,
                std::optional<double> otherwise = {});

    /// @throws std::invalid_argument
    void refuse_others() const;

  private:
    CallText call_;
    std::string example_;
};

} // namespace ground
