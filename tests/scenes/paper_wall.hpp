#pragma once
/// The wall of the paper as tests and benchmarks use it.

#include "dem/block/discretisation.hpp"
#include "dem/solver/push.hpp"

#include <cstdint>

namespace scenes {

/// Everything about one wall but its discretisation.
struct Scene {
    dem::WallGeometry wall;
    dem::Elastic stone;
    dem::Beam beam;
    dem::Loads loads;
    dem::JointMaterial joint;                    ///< of every joint ID, base and beam
    dem::CrackMaterial crack;                    ///< of every crack ID
    dem::Closure closure = dem::Closure::linear; ///< of dry joints
};

/// Tables 3 and 4, Eq. 2; beam and densities as in configs/wall.ini.
/// @param stress_mpa one of 0.15, 0.50, 0.75 (interpolated modulus), 1.00, 1.25
[[nodiscard]] Scene paper_wall(double stress_mpa);

/// A block of length x height on a dry joint, under a rigid weightless beam, pushed at its top.
[[nodiscard]] Scene monolith(double length, double height, double vertical_stress,
                             double joint_kn);

[[nodiscard]] dem::Model model_of(const Scene& scene, const dem::Discretisation& d = {});
[[nodiscard]] dem::WallMaterials uniform(const Scene& scene, const dem::Model& model);

/// Sample of Table 5 (non-spatial): one draw per wall of the two stiffness factors, f_t, phi_u,
/// phi_j, cut at -3.9 and 5 standard deviations. A stand-in until uq/ draws samples.
[[nodiscard]] dem::WallMaterials table5_sample(const Scene& scene, const dem::Model& model,
                                               std::uint64_t sample);

/// The same with one draw per joint ID and per crack ID (spatial, independent).
[[nodiscard]] dem::WallMaterials
table5_spatial_sample(const Scene& scene, const dem::Model& model, std::uint64_t sample);

[[nodiscard]] double tan_deg(double degrees);

/// Largest force of the curve [N].
[[nodiscard]] double peak_force(const dem::PushResult& result);

} // namespace scenes
