#pragma once
/// The discretised wall, which all samples of a study share. It is built once and read by every
/// push.

#include "dem/block/block_element.hpp"
#include "dem/block/discretisation.hpp"
#include "dem/scene/layout.hpp"
#include "dem/scene/wall.hpp"

#include <vector>

namespace dem {

/// Where a block is in the solver's arrays.
struct BlockPlace {
    int element = 0;     ///< index in Model::elements
    int first_point = 0; ///< in the arrays of points
    int first_mode = 0;  ///< in the arrays of modes
};

constexpr int kBaseMaterial = -1; ///< Contact::material of the joint at the base
constexpr int kBeamMaterial = -2; ///< Contact::material of the joint at the beam

/// A contact between point a and point b of the wall. The ground is Model::ground_point.
struct Contact {
    int a = 0, b = 0;
    double nx = 0.0, nz = 0.0; ///< unit normal from a to b; the tangent is (nz, -nx)
    double area = 0.0;         ///< [m2]
    /// Joint or crack ID - 1, kBaseMaterial or kBeamMaterial; of a joint with mortar n_cracks +
    /// joint ID - 1.
    int material = 0;
    int face = 0; ///< index in Layout::faces
};

/// A typical stiffness of the contacts over the samples of a study, > 0. It sets the modes that
/// are kept and the fictitious masses.
struct ReferenceStiffness {
    JointMaterial joint;
    CrackMaterial crack;
};

/// Normal and tangential [Pa/m].
struct FaceStiffness {
    double kn, ks;
};

struct Model {
    Beam beam;
    Loads loads;
    Elastic stone; ///< reference values, from which the elasticity of a sample is scaled
    Layout layout;
    std::vector<BlockElement> elements;
    std::vector<BlockPlace> places; ///< by block
    std::vector<Contact> dry;       ///< joints with friction
    std::vector<Contact> cracks;    ///< in units, and joints with mortar
    std::vector<Contact> tied;      ///< elastic (beam glued to the wall)
    ReferenceStiffness reference;
    int n_points = 0;
    int n_modes = 0;
    int ground_point = 0; ///< equal to n_points; it never moves
};

/// @throws std::invalid_argument if a value is outside its range, a block touches no other, or
/// the load line is
/// outside the beam
[[nodiscard]] Model discretise(Layout layout, const Elastic& stone, const Beam& beam,
                               const Loads& loads, const ReferenceStiffness& reference,
                               const Discretisation& discretisation = {});

/// The same of a wall in courses.
[[nodiscard]] Model discretise(const WallGeometry& wall, const Elastic& stone, const Beam& beam,
                               const Loads& loads, const ReferenceStiffness& reference,
                               const Discretisation& discretisation = {});

/// The typical stiffness of the contacts of a face.
[[nodiscard]] FaceStiffness reference_of(const Model& model, const Face& face);

/// The stone of a block, with its Young's modulus and density, where the wall's own is `stone`.
[[nodiscard]] const Elastic& stone_of(const Model& model, int block, const Elastic& stone);

/// Whether the horizontal forces on a block go straight into the ground.
[[nodiscard]] bool is_supported(const Model& model, int block);

} // namespace dem
