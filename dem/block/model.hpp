#pragma once
/// The discretised wall: what all its samples share. Built once, read by every push.

#include "dem/block/block_element.hpp"
#include "dem/block/discretisation.hpp"
#include "dem/scene/layout.hpp"
#include "dem/scene/wall.hpp"

#include <vector>

namespace dem {

/// A block in the solver's arrays.
struct BlockPlace {
    int element = 0;     ///< index in Model::elements
    int first_point = 0; ///< in the arrays of points
    int first_mode = 0;  ///< in the arrays of modes
};

constexpr int kBaseMaterial = -1;
constexpr int kBeamMaterial = -2;

/// A contact point between point a and point b of the wall (Model::ground_point for the
/// ground).
struct Contact {
    int a = 0, b = 0;
    double nx = 0.0, nz = 0.0; ///< unit normal from a to b; the tangent is (nz, -nx)
    double area = 0.0;         ///< [m2]
    int material = 0;          ///< joint or crack ID - 1, kBaseMaterial or kBeamMaterial
    int face = 0;              ///< index in Layout::faces
};

/// Stiffness that contacts have on average over the samples of a study. Sets the fictitious
/// masses, not the answer.
struct ReferenceStiffness {
    JointMaterial joint;
    CrackMaterial crack;
};

struct Model {
    WallGeometry wall;
    Beam beam;
    Loads loads;
    Elastic
        stone; ///< reference values: modes and fictitious masses of a sample are scaled from them
    Layout layout;
    std::vector<BlockElement> elements;
    std::vector<BlockPlace> places; ///< by block
    std::vector<Contact> dry;       ///< joints with friction
    std::vector<Contact> cracks;    ///< in units
    std::vector<Contact> tied;      ///< elastic (beam glued to the wall)
    ReferenceStiffness reference;
    int n_points = 0;
    int n_modes = 0;
    int ground_point = 0; ///< = n_points: never moves
};

/// @throws std::invalid_argument if a size makes no wall (no course, load line outside the
/// beam, ...)
[[nodiscard]] Model discretise(const WallGeometry& wall, const Elastic& stone, const Beam& beam,
                               const Loads& loads, const ReferenceStiffness& reference,
                               const Discretisation& discretisation = {});

} // namespace dem
