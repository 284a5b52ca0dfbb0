#pragma once
/// Parts of the table of keys of the study file.

#include "app/input/keys/study_keys.hpp"

#include <array>
#include <span>
#include <string_view>

namespace app {

/// A word of a key, and what it stands for.
constexpr Named named(std::string_view word, auto value)
{
    return {word, static_cast<double>(value)};
}

inline constexpr std::array kYesNo = {named("yes", true), named("no", false)};

/// The condition of keys that say how a file is read.
inline constexpr Condition kOfFile{
    asks<&Study::geometry>([](auto& g) { return !g.file.empty(); }),
    "there is no wall.geometry to read; remove it", true};

inline constexpr Condition kWithBaseJoint{
    asks<&Study::wall>([](auto& w) { return w.base == dem::Base::joint; }),
    "there is no base joint; write wall.base = joint, or remove it", true};
inline constexpr Condition kWithBeam{asks<&Study::beam>([](auto& b) { return b.present; }),
                                     "there is no beam; write beam.present = yes, or remove it",
                                     true};
inline constexpr Condition kWithBeamJoint{
    asks<&Study::beam>([](auto& b) { return b.interface == dem::BeamInterface::joint; }),
    "there is no beam joint; write beam.interface = joint, or remove it", true};
inline constexpr Condition kWithGravity{
    asks<&Study::load>([](auto& l) { return l.gravity > 0.0; }), "load.gravity is 0"};

/// The condition of keys of walls that are shaken.
inline constexpr Condition kShaken{
    asks<&Study::shaking>([](auto& k) { return !k.records.empty(); }),
    "there is no shaking.records; write it, or remove this key", true};

inline constexpr std::array kNone = {named("none", 0)};
inline constexpr std::array kEnvelopes = {named("coulomb", dem::Envelope::coulomb),
                                          named("hyperbolic", dem::Envelope::hyperbolic)};
inline constexpr std::array kFidelities = {
    named("rigid", dem::Fidelity::rigid), named("simple", dem::Fidelity::simple),
    named("standard", dem::Fidelity::standard), named("zones", dem::Fidelity::zones),
    named("fine", dem::Fidelity::fine)};

[[nodiscard]] std::span<const Key> wall_keys();        ///< wall, stone, lintel
[[nodiscard]] std::span<const Key> joint_keys();       ///< joint
[[nodiscard]] std::span<const Key> unit_keys();        ///< unit
[[nodiscard]] std::span<const Key> support_keys();     ///< beam, base
[[nodiscard]] std::span<const Key> shaking_keys();     ///< shaking
[[nodiscard]] std::span<const Key> solver_keys();      ///< load, solver, output
[[nodiscard]] std::span<const Key> random_keys();      ///< uq, reliability, fragility
[[nodiscard]] std::span<const Key> calibration_keys(); ///< calibration

} // namespace app
