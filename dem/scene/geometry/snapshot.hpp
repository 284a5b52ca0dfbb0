#pragma once
/// A wall at one instant: blocks with their displacements, joints with their openings and
/// slips. Pictures, ParaView series and the failure-mode rule read it; the solver never does.

#include <vector>

namespace dem {

struct Point {
    double x = 0.0; ///< along the wall, positive in the direction of the push [m]
    double z = 0.0; ///< upwards from the floor [m]
};

enum class FaceKind { bed_joint, head_joint, unit_crack, beam_joint, base_joint };

/// One contact point of a face. Opening and tension are positive.
struct ContactState {
    Point at{};            ///< undeformed position [m]
    double area = 0.0;     ///< tributary area [m2]
    double opening = 0.0;  ///< u_n [m]; negative where the contact is compressed
    double slip = 0.0;     ///< total tangential displacement of block b past block a [m]
    double sigma = 0.0;    ///< normal stress [Pa], tension positive
    double tau = 0.0;      ///< shear stress [Pa]
    double damage = 0.0;   ///< D of Table 2, in [0, 1]; 0 in dry joints
    double crushed = 0.0;  ///< thickness that is crushed [m]
    double crushing = 0.0; ///< share of the compressive strength that is lost, in [0, 1]
    /// Mean stresses since the snapshot before where the push was asked for them, else those of
    /// the instant [Pa].
    double mean_sigma = 0.0, mean_tau = 0.0;
};

/// The contact points along one straight piece of joint between two blocks (block a below or
/// left of block b).
struct FaceState {
    FaceKind kind = FaceKind::bed_joint;
    int id = 0;      ///< joint ID or crack ID, from 1; 0 at the base and at the beam
    int block_a = 0; ///< index in Snapshot::blocks; -1 is the ground
    int block_b = 0; ///< index in Snapshot::blocks
    Point normal;    ///< unit vector from a to b
    /// Direction of the normal stresses now, times the share of the area that is in contact
    /// [-]: `normal` with small displacements.
    Point acting;
    std::vector<ContactState> contacts; ///< ordered along the face
};

struct BlockState {
    /// Undeformed boundary with all contact points on it [m], counter-clockwise.
    std::vector<Point> outline;
    std::vector<Point> displacement; ///< of each outline point [m]
    int course = 0;                  ///< from 1 at the bottom; 0 is the loading beam
    int unit =
        0; ///< number of the unit that the block is part of, from 1; 0 is the loading beam
};

struct Snapshot {
    double displacement = 0.0; ///< of the load line [m]
    double force = 0.0;        ///< horizontal load [N]
    std::vector<BlockState> blocks;
    std::vector<FaceState> faces;
};

} // namespace dem
