#pragma once
/// Tables of the model that a step with finite displacements needs besides the step's own
/// tables.

#include "dem/contact/contact_operator.hpp"
#include "dem/kinematics/face_pair.hpp"
#include "dem/kinematics/top_load.hpp"

#include <vector>

namespace dem {

struct Model;
struct StepTables;

struct FiniteTables {
    /// The first modes of a block are its rigid motions; the others live in the frame of the
    /// block.
    struct BlockRow {
        int rigid = 0;           ///< rigid modes, 0 to 3
        double motion[3][3]{};   ///< x, z [m] and rotation [rad] of the pivot, by rigid mode
        bool turns_axes = true;  ///< motion is along the block's own axes; else along x and z
        double x = 0.0, z = 0.0; ///< pivot, undeformed [m]
        double centre_x = 0.0, centre_z = 0.0; ///< of gravity, from the pivot [m]
        double volume = 0.0;                   ///< [m3]
    };
    std::vector<BlockRow> blocks;
    std::vector<ContactOperator> elastic; ///< by element: without rigid modes
    std::vector<FacePair> pairs;          ///< by run of contacts: dry, tied, cracks
    std::vector<double> place;            ///< by contact: along the overlap, 0 to 1
    /// Blocks on which a block comes to lie as it slides, outwards from the last of those under
    /// it.
    struct Reach {
        int home = 0;    ///< pair over whose end the upper block slides
        bool far = true; ///< end along the tangent, or against it
        int run = 0;     ///< of contacts of `home`, in StepTables::dry: places, areas and law
        int first = 0, count = 0; ///< in `further`
    };
    std::vector<Reach> reaches;
    std::vector<FacePair> further; ///< rows of the state: most_points for each
    int most_points = 0;
    std::vector<int> supported; ///< frames that hand their forces to the ground
    LoadPoint load;
    double load_area = 0.0;   ///< on which the vertical stress acts [m2]
    int beam = 0, ground = 0; ///< frames; without a beam they are the same
};

[[nodiscard]] FiniteTables finite_tables(const Model& model, const StepTables& tables);

} // namespace dem
