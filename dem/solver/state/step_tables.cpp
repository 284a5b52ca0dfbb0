#include "dem/solver/state/step_tables.hpp"

#include "dem/block/model.hpp"

#include <algorithm>
#include <cstddef>

namespace dem {

namespace {

/// Matrices of all blocks that are larger together do not fit the second cache of today's
/// processors: a free choice.
constexpr std::size_t kManyMatrices = 1 << 20; // [bytes]

/// Index of a dry contact's law in LaneLaws::dry.
int dry_law(const Model& m, const Contact& c)
{
    if (c.material == kBaseMaterial) return m.layout.n_joints;
    if (c.material == kBeamMaterial) return m.layout.n_joints + 1;
    return c.material;
}

/// Numbers the contacts of a list from `first` on and groups them by face.
template <class Law>
std::vector<ContactRun> runs_of(const std::vector<Contact>& contacts, int first, Law law)
{
    std::vector<ContactRun> runs;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        if (k == 0 || contacts[k].face != contacts[k - 1].face)
            runs.push_back({first + static_cast<int>(k), 0, law(contacts[k])});
        ++runs.back().count;
    }
    return runs;
}

/// A contact by its number.
const Contact& contact_of(const Model& m, const StepTables& t, int number)
{
    if (number < t.first_tied) return m.dry[number];
    if (number < t.first_crack) return m.tied[number - t.first_tied];
    return m.cracks[number - t.first_crack];
}

/// First contact of each face.
std::vector<int> first_contacts(const Model& m, const StepTables& t)
{
    std::vector<int> first(m.layout.faces.size(), 0);
    for (const auto* runs : {&t.dry, &t.tied, &t.cracks})
        for (const ContactRun& r : *runs) first[contact_of(m, t, r.first).face] = r.first;
    return first;
}

std::vector<int> counts(const Model& m, const StepTables& t)
{
    std::vector<int> count(m.layout.faces.size(), 0);
    for (const auto* runs : {&t.dry, &t.tied, &t.cracks})
        for (const ContactRun& r : *runs) count[contact_of(m, t, r.first).face] = r.count;
    return count;
}

/// Contacts of each block, face by face in the order of the layout, which is the same for all
/// blocks of an element.
std::vector<std::vector<int>> ports_by_block(const Model& m, const StepTables& t)
{
    std::vector<std::vector<int>> ports(m.layout.blocks.size());
    const std::vector<int> first = first_contacts(m, t), count = counts(m, t);
    for (std::size_t f = 0; f < m.layout.faces.size(); ++f)
        for (int k = first[f]; k < first[f] + count[f]; ++k)
            for (const int block : {m.layout.faces[f].a, m.layout.faces[f].b})
                if (block != kGround) ports[block].push_back(k);
    return ports;
}

/// +1 for the block that the contact's normal points to, -1 for the other one.
double side_of(const Model& m, const Contact& c, int block)
{
    return m.layout.faces[c.face].b == block ? 1.0 : -1.0;
}

ContactOperator port_matrix(const Model& m, const StepTables& t, int block,
                            const std::vector<int>& ports)
{
    const BlockPlace& place = m.places[block];
    const Eigen::MatrixXd& phi = m.elements[place.element].phi;
    ContactOperator a;
    a.ports = static_cast<int>(ports.size());
    a.modes = static_cast<int>(phi.cols());
    const std::size_t rows = 2 * ports.size(), modes = static_cast<std::size_t>(a.modes);
    a.to_modes.resize(rows * modes);
    a.to_contacts.resize(rows * modes);
    for (std::size_t p = 0; p < ports.size(); ++p) {
        const Contact& c = contact_of(m, t, ports[p]);
        const double side = side_of(m, c, block);
        const int point = (side > 0.0 ? c.b : c.a) - place.first_point;
        for (std::size_t i = 0; i < modes; ++i) {
            const double x = phi(2 * point, i), z = phi(2 * point + 1, i);
            const double moves[] = {side * (c.nx * x + c.nz * z), side * (c.nz * x - c.nx * z)};
            for (std::size_t j = 0; j < 2; ++j) {
                a.to_contacts[i * rows + 2 * p + j] = moves[j];
                a.to_modes[(2 * p + j) * modes + i] = -c.area * moves[j];
            }
        }
    }
    return a;
}

/// Rows of the contacts that feel a common horizontal motion of the given blocks.
template <class Belongs>
std::vector<HorizontalShare> shares(const Model& m, const StepTables& t, Belongs belongs)
{
    std::vector<HorizontalShare> list;
    for (int k = 0; k < t.n_contacts; ++k) {
        const Contact& c = contact_of(m, t, k);
        const Face& f = m.layout.faces[c.face];
        const int side = (belongs(f.b) ? 1 : 0) - (belongs(f.a) ? 1 : 0);
        if (side == 0) continue;
        if (c.nx != 0.0) list.push_back({2 * k, side * c.nx, c.area});
        if (c.nz != 0.0) list.push_back({2 * k + 1, side * c.nz, c.area});
    }
    return list;
}

void tabulate_blocks(const Model& m, StepTables& t)
{
    const std::vector<std::vector<int>> ports = ports_by_block(m, t);
    t.matrices.resize(m.elements.size());
    for (int b = 0; b < static_cast<int>(m.layout.blocks.size()); ++b) {
        const BlockPlace& place = m.places[b];
        const BlockElement& e = m.elements[place.element];
        ContactOperator& a = t.matrices[place.element];
        if (a.modes == 0) a = port_matrix(m, t, b, ports[b]);
        t.blocks.push_back({place.element, static_cast<int>(t.port_contact.size()),
                            place.first_mode, static_cast<int>(e.phi.cols())});
        t.port_contact.insert(t.port_contact.end(), ports[b].begin(), ports[b].end());
        t.lambda.insert(t.lambda.end(), e.lambda.begin(), e.lambda.end());
    }
}

std::size_t bytes_of(const std::vector<ContactOperator>& matrices)
{
    std::size_t sum = 0;
    for (const ContactOperator& a : matrices) sum += dem::bytes_of(a);
    return sum;
}

/// The matrices of elements that only one block has.
void store_own_matrices_once(const Model& m, StepTables& t)
{
    std::vector<int> blocks(m.elements.size(), 0);
    for (const auto& b : t.blocks) ++blocks[b.element];
    for (std::size_t e = 0; e < m.elements.size(); ++e) {
        if (blocks[e] != 1) continue;
        t.matrices[e] = with_own_matrix(t.matrices[e]);
        t.finite.elastic[e] = with_own_matrix(t.finite.elastic[e]);
    }
}

} // namespace

StepTables step_tables(const Model& m)
{
    StepTables t;
    t.first_tied = static_cast<int>(m.dry.size());
    t.first_crack = t.first_tied + static_cast<int>(m.tied.size());
    t.n_contacts = t.first_crack + static_cast<int>(m.cracks.size());
    t.dry = runs_of(m.dry, 0, [&m](const Contact& c) { return dry_law(m, c); });
    t.tied = runs_of(m.tied, t.first_tied, [](const Contact&) { return 0; });
    t.cracks = runs_of(m.cracks, t.first_crack, [](const Contact& c) { return c.material; });
    for (const ContactRun& run : t.dry) {
        const Face& face = m.layout.faces[m.dry[run.first].face];
        t.dry_blocks.push_back({face.a, face.b});
    }
    for (int k = 0; k < t.n_contacts; ++k) t.area.push_back(contact_of(m, t, k).area);
    tabulate_blocks(m, t);
    t.body_forces = m.loads.pattern == LoadPattern::body;
    if (!t.body_forces)
        t.beam = shares(m, t, [&m](int block) { return block == m.layout.beam; });
    t.ground =
        shares(m, t, [&m](int block) { return block == kGround || is_supported(m, block); });
    t.finite = finite_tables(m, t);
    if (bytes_of(t.matrices) > kManyMatrices) store_own_matrices_once(m, t);
    return t;
}

} // namespace dem
